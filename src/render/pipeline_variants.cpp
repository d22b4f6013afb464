#include "render/pipeline_variants.h"

#include "render/shader_library.h"
#include "shared/spec_ids.h"

namespace tetralux::render {

gpu::SpecConstants FrameVariant::specConstants() const {
  return {{SPEC_WIDE_ADDRESSING, wideAddressing}, {SPEC_PERSPECTIVE, perspective},
          {SPEC_CELL_FIELD, cellField},           {SPEC_NEAR_CELLS, nearCells},
          {SPEC_SILHOUETTE, silhouette},          {SPEC_DISPATCH_THREADS, dispatchThreads}};
}

ComputeVariants::ComputeVariants(const gpu::Context& context, const std::string& shader)
    : context_(context), name_(shader) {}

const gpu::ComputePipeline& ComputeVariants::get(const gpu::SpecConstants& constants) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> key;
  for (const gpu::SpecConstant& c : constants) key.emplace_back(c.id, c.value);
  const auto found = pipelines_.find(key);
  if (found != pipelines_.end()) return found->second;
  if (!shader_) shader_.emplace(loadShader(context_, name_));
  return pipelines_.emplace(key, gpu::ComputePipeline(context_, *shader_, constants)).first->second;
}

}  // namespace tetralux::render
