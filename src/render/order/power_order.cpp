#include "render/order/power_order.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "shared/power_keys.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

using namespace gpu::access;

struct KeyPush {
  SphereAddresses spheres;
  VkDeviceAddress keys;
  glm::vec4 weights;
  float offset;
  std::uint32_t cellCount;
};

struct TiePush {
  MeshAddresses mesh;
  TopologyAddresses topology;
  VkDeviceAddress keys;
};

// A power as the shader computes it: weights . (c, |c|^2 - r^2) + offset.
struct ScaledPower {
  glm::dvec4 weights{0.0};
  double offset = 0.0;
};

// The eye is the device's, single precision: the keys are exactly right for it, and checked with it.
ScaledPower scaledPower(const FrameSetup& setup, const MeshSpace& space) {
  const glm::dvec3 eye(setup.view.eyeMesh);
  const glm::dvec3 forward(setup.view.viewFromMesh[2]);
  const glm::dvec4 weights = setup.perspective ? glm::dvec4(-2.0 * eye, 1.0) : glm::dvec4(forward, 0.0);
  // Powers of points are largest in a corner of the box, and least there, too, or where the eye is nearest.
  const auto powerOf = [&](const glm::dvec3& p) { return glm::dot(weights, glm::dvec4(p, glm::dot(p, p))); };
  double low = powerOf(setup.perspective ? glm::clamp(eye, space.low, space.high) : space.low);
  double high = low;
  for (int corner = 0; corner < 8; corner++) {
    const double power =
        powerOf({(corner & 1) != 0 ? space.high.x : space.low.x, (corner & 2) != 0 ? space.high.y : space.low.y,
                 (corner & 4) != 0 ? space.high.z : space.low.z});
    low = std::min(low, power);
    high = std::max(high, power);
  }
  const double largest = std::max(0.5 * (high - low), 1e-30) / static_cast<double>(shared::POWER_INSIDE);
  const double scale = std::exp2(-std::ceil(std::log2(largest)));  // a power of two rounds no weight
  return {scale * weights, -scale * 0.5 * (low + high)};
}

}  // namespace

PowerOrder::PowerOrder(const gpu::Context& context, const OrderMesh& mesh, const GpuTopology& topology,
                       SortVariant variant, OrderCheck* check)
    : KeyOrder(context, Order::Power, SortRange{0, shared::POWER_KEY_BITS}, variant, check),
      topology_(topology),
      spheres_(context, mesh.mesh, *mesh.adjacency, mesh.space),
      keys_(context, "order/power_key.comp"),
      ties_(context, "order/power_ties.comp") {}

void PowerOrder::recordKeys(const OrderInputs& inputs) {
  const GpuMesh& mesh = inputs.mesh;
  const gpu::Buffer& keys = inputs.sort.keys();
  const ScaledPower power = scaledPower(inputs.setup, mesh.space());
  gpu::CommandBuffer& commands = inputs.recorder.pass("order");
  const KeyPush keyPush{spheres_.addresses(), keys.address(), glm::vec4(power.weights),
                        static_cast<float>(power.offset), mesh.cellCount()};
  commands.dispatch(keys_.get({{SPEC_WIDE_ADDRESSING, inputs.variant.wideAddressing}}),
                    {spheres_.leading(), spheres_.rest(), inputs.sort.keyView(), keys}, keyPush, mesh.cellCount());
  commands.barrier(kComputeWrite, kComputeReadWrite);
  const TiePush tiePush{mesh.addresses(), topology_.addresses(), keys.address()};
  for (std::uint32_t step = 1; step < shared::POWER_LEVELS; step++) {
    commands.dispatch(ties_.get(inputs.variant.specConstants()),
                      {inputs.view, mesh.cells(), mesh.vertices(), mesh.cellScalars(), topology_.neighbors(),
                       topology_.sides(), inputs.sort.keyView(), keys},
                      tiePush, mesh.cellCount());
    commands.barrier(kComputeWrite, kComputeReadWrite);
  }
}

}  // namespace tetralux::render
