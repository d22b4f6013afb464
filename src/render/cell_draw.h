// How the cells of a batch get to the rasteriser: what the passes that draw cells ("raster", "apart") have in common.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gpu/commands.h"
#include "render/appearance_buffer.h"
#include "render/batch.h"
#include "render/gpu_mesh.h"
#include "render/gpu_truth_table.h"
#include "render/integration/integration_tables.h"
#include "render/order/cell_order.h"
#include "render/pipeline_variants.h"
#include "render/transfer_buffer.h"
#include "shared/cell_push.h"

namespace tetralux::render {

// A batch of cells with all that their shaders read. Everything outlives the recorded commands.
struct CellBatch {
  const GpuMesh& mesh;
  const TransferBuffer& transfer;
  const IntegrationTables& tables;
  const gpu::Buffer& view;  // FrameView
  const GpuTruthTable& truthTable;
  const CellSequence& sequence;
  const BatchStorage& storage;
  shared::CellPush push;
  const AppearanceBuffer* appearance = nullptr;  // what is shown beside the volume; of outlines alone
};

// Pipelines that draw cells with one kind of fragment shader, made when first needed.
class CellDraw {
 public:
  //   fans, gator   names of the fragment shader for cells projected before and for those that raster/gator.vert
  //                 projects
  //   appearance    for cells projected before, with all that is shown beside the volume
  CellDraw(const gpu::Context& context, const std::string& fans, const std::string& gator,
           const std::string& appearance);

  // Draws a batch within a begun rendering.
  //   format    of the attachment; undefined: none
  //   kBuffer   as of SPEC_KBUFFER
  //   further   what the fragment shader binds behind the tables of integration
  void record(gpu::CommandBuffer& commands, const FrameVariant& variant, const CellBatch& batch, VkFormat format,
              std::uint32_t kBuffer = 0, const std::vector<gpu::Descriptor>& further = {});

 private:
  std::vector<gpu::Descriptor> bindings(const FrameVariant& variant, const CellBatch& batch) const;
  const gpu::GraphicsPipeline& pipeline(const FrameVariant& variant, const AppearanceBuffer* appearance,
                                        VkFormat format, std::uint32_t kBuffer);

  const gpu::Context& context_;
  // Loaded when first needed.
  struct Shaders {
    std::string vertexName;
    std::string fragmentName;
    std::optional<gpu::Shader> vertex;
    std::optional<gpu::Shader> fragment;

    void load(const gpu::Context& context);
  };
  Shaders fans_;
  Shaders gator_;
  Shaders appearance_;
  std::map<std::vector<std::uint32_t>, gpu::GraphicsPipeline> pipelines_;  // by all that distinguishes them
};

}  // namespace tetralux::render
