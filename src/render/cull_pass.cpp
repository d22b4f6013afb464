#include "render/cull_pass.h"

namespace tetralux::render {
namespace {

struct CullPush {
  MeshAddresses mesh;
  VkDeviceAddress keys;
};

}  // namespace

CullPass::CullPass(const gpu::Context& context) : pipelines_(context, "cull/cull.comp") {}

void CullPass::record(gpu::CommandBuffer& commands, const FrameVariant& variant, const GpuMesh& mesh,
                      const gpu::TexelView& support, const gpu::Buffer& view, const gpu::Buffer& keys,
                      const gpu::Buffer& counters) {
  const CullPush push{mesh.addresses(), keys.address()};
  commands.dispatch(pipelines_.get(variant.specConstants()),
                    {view, mesh.cells(), mesh.vertices(), mesh.cellScalars(), support, keys, counters}, push,
                    mesh.cellCount());
}

}  // namespace tetralux::render
