// Passes "enter" and "march": rays walk through the mesh's adjacency (Weiler et al. 2003, HARC; Espinha and Celes
// 2005).
//
// A picture's order is right by construction, and only cells that are hit cost anything. Where cells overlap, each
// layer is walked by itself (the mesh is cut where it is folded, mesh/cut_folds.h), and rays change between layers from
// segment to segment.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "gpu/commands.h"
#include "render/frame_view.h"
#include "render/gpu_mesh.h"
#include "render/integration/integration_tables.h"
#include "render/march_storage.h"
#include "render/pipeline_variants.h"
#include "render/transfer_buffer.h"

namespace tetralux::render {

struct FrameInputs;

class MarchPass {
 public:
  explicit MarchPass(const gpu::Context& context);

  // Lists the faces where the rays of a band enter the mesh, near ones first, and the tiles of pixels that have any;
  // empties the band's colours. When there was too little room (MarchStorage::grow), what follows is wrong.
  void recordEnter(gpu::CommandBuffer& commands, const FrameInputs& inputs, const MarchStorage& storage,
                   const shared::PixelBand& band);

  // Where the eye may be inside the mesh: finds the cells in which rays start. Counts the rays for which it
  // has to be recorded again.
  void recordSeek(gpu::CommandBuffer& commands, const FrameInputs& inputs, const MarchStorage& storage,
                  const shared::PixelBand& band);

  // Walks. Counts the rays that are not through; recorded again, they go on.
  void recordMarch(gpu::CommandBuffer& commands, const FrameInputs& inputs, const MarchStorage& storage,
                   const shared::PixelBand& band);

  // Writes a band's colours into the target: copies them where it holds the same numbers, draws them where it rounds.
  void recordShow(gpu::CommandBuffer& commands, const MarchStorage& storage, const shared::PixelBand& band,
                  const gpu::AttachmentImage& target, bool clear);

 private:
  // What follows rays, in single or in double precision.
  struct Walk {
    Walk(const gpu::Context& context, const std::string& suffix);
    ComputeVariants enter;
    ComputeVariants seek;
    ComputeVariants march;
    ComputeVariants marchMethods;     // with any method of integration
    ComputeVariants marchAppearance;  // with what is shown beside the volume
  };

  Walk& walk(const FrameVariant& variant);
  const gpu::GraphicsPipeline& showPipeline(VkFormat format);

  const gpu::Context& context_;
  gpu::Shader showVertex_;
  gpu::Shader showFragment_;
  ComputeVariants bin_;
  ComputeVariants arrange_;
  std::optional<Walk> single_;
  std::optional<Walk> double_;  // where the device can
  std::map<VkFormat, gpu::GraphicsPipeline> show_;
};

}  // namespace tetralux::render
