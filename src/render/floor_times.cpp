#include "render/floor_times.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "gpu/recorder.h"

namespace tetralux::render {
namespace {

constexpr int kRepeats = 7;
constexpr std::uint64_t kLargestCopyBytes = 256u << 20;
constexpr std::uint64_t kCopyUnit = 256;  // GPUs copy odd sizes at a fraction of the rate

// GPUs raise their clocks when they have been busy for a while.
constexpr double kGpuWarmUpMs = 300.0;

template <typename Measure>
double medianOf(const gpu::Context& context, const Measure& measure) {
  // At least once: memory is touched, pipelines are awake.
  const auto start = std::chrono::steady_clock::now();
  do measure();
  while (!context.info().isCpu &&
         std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() < kGpuWarmUpMs);
  std::vector<double> ms;
  for (int i = 0; i < kRepeats; i++) ms.push_back(measure());
  std::sort(ms.begin(), ms.end());
  return ms[ms.size() / 2];
}

}  // namespace

double emptySubmitMs(const gpu::Context& context) {
  return medianOf(context, [&] { return gpu::CommandBuffer(context).submitAndWait(); });
}

double copyMs(const gpu::Context& context, std::uint64_t bytes) {
  if (bytes == 0) return 0.0;
  const std::uint64_t copied = std::clamp<std::uint64_t>(bytes / 2 / kCopyUnit * kCopyUnit, 4, kLargestCopyBytes);
  const gpu::Buffer from(context, copied, gpu::MemoryKind::Device, "floor, read");
  const gpu::Buffer to(context, copied, gpu::MemoryKind::Device, "floor, written");
  const double ms = medianOf(context, [&] {
    gpu::Recorder recorder(context, gpu::bestTiming(context.info()));
    recorder.pass("copy").copy(from, 0, to, 0, copied);
    recorder.sync();
    return recorder.passTimes().front().gpuMs;
  });
  return ms * std::max(1.0, static_cast<double>(bytes) / 2.0 / static_cast<double>(copied));
}

Camera besideMesh(const Camera& camera, ImageSize size, const MeshSpace& space) {
  // Of a ball around the mesh, which lies within [-1, 1] in mesh space: in view space, world units.
  const double radius = std::sqrt(3.0) * space.scale;
  const glm::dmat3 rotation = camera.viewRotation();
  const glm::dvec3 middle = rotation * (space.center - camera.eye);
  const double farthest = std::max(middle.z + radius, radius);
  const double halfWidth =
      0.5 * size.width / camera.pixelsPerUnit(size) * (camera.projection == Projection::Perspective ? farthest : 1.0);
  const glm::dvec3 right = glm::transpose(rotation)[0];
  const glm::dvec3 shift = (middle.x + halfWidth + 2.0 * radius) * right;
  Camera beside = camera;
  beside.eye += shift;
  beside.center += shift;
  return beside;
}

}  // namespace tetralux::render
