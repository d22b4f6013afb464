// Kernels on the device, timed there: by timestamps on GPUs, by waiting for a submission on processors.
#include <algorithm>

#include "bench_device.h"
#include "mesh/random.h"
#include "render/cull_pass.h"
#include "render/renderer.h"
#include "render/sort_pass.h"
#include "shared/counters.h"

namespace tetralux::bench {
namespace {

using namespace gpu::access;

// The device, or null after the benchmark was told that there is none.
const gpu::Context* deviceFor(benchmark::State& state) {
  if (!device()) state.SkipWithError("no usable Vulkan device");
  return device();
}

void radixSort(benchmark::State& state) {
  const gpu::Context* context = deviceFor(state);
  if (!context) return;
  constexpr std::uint32_t kKeys = 1000000;
  constexpr render::SortRange kRange{0, 24};
  std::vector<std::uint32_t> keys(kKeys);
  for (std::uint32_t i = 0; i < kKeys; i++) keys[i] = static_cast<std::uint32_t>(randomUnit(1, i) * 0x1p24);
  const gpu::Buffer unsorted = gpu::makeBuffer(*context, keys, "unsorted keys");
  const render::SortVariant variant = render::bestSortVariant(context->info());
  render::SortStorage storage(*context, kKeys, variant);
  render::SortPass pass(*context, variant);
  const auto sortSeconds = [&] {
    gpu::Recorder recorder(*context, gpu::bestTiming(context->info()));
    gpu::CommandBuffer& copy = recorder.pass("copy");  // the sort destroys its keys
    copy.copy(unsorted, 0, storage.keys(), 0, sizeof(std::uint32_t) * kKeys);
    copy.barrier(kTransferWrite, kComputeReadWrite);
    pass.record(recorder.pass("sort"), storage, kRange, /*wideAddressing=*/false);
    recorder.sync();
    return passSeconds(recorder, "sort");
  };
  sortSeconds();  // makes pipelines
  for ([[maybe_unused]] auto _ : state) state.SetIterationTime(sortSeconds());
  const auto order = gpu::downloadVector<std::uint32_t>(*context, storage.order(kRange), kKeys);
  if (!std::is_sorted(order.begin(), order.end(), [&](auto a, auto b) { return keys[a] < keys[b]; }))
    state.SkipWithError("keys are not in order");
  state.SetItemsProcessed(state.iterations() * kKeys);
}
BENCHMARK(radixSort)->Name("device/radix_sort")->Unit(benchmark::kMillisecond)->UseManualTime();

void cull(benchmark::State& state) {
  const gpu::Context* context = deviceFor(state);
  if (!context) return;
  const render::GpuMesh mesh(*context, gridMesh(), scalarField(gridMesh(), "", "bench"));
  const render::TransferBuffer transfer(*context, gridTransfer(), mesh.space());
  const render::FrameSetup setup = render::makeFrameSetup(gridCamera(), {512, 512}, mesh.space(), mesh.cellCount(),
                                                          transfer.supportCount(), /*keyBits=*/24);
  const gpu::Buffer view = gpu::makeBuffer(*context, std::vector{setup.view}, "view");
  const gpu::Buffer counters =
      gpu::Buffer(*context, sizeof(shared::FrameCounters), gpu::MemoryKind::Device, "counters");
  const gpu::Buffer keys = gpu::Buffer(*context, 4ull * mesh.cellCount(), gpu::MemoryKind::Device, "keys");
  render::FrameVariant variant;
  variant.nearCells = setup.nearCells;
  render::CullPass pass(*context);
  const auto cullSeconds = [&] {
    gpu::Recorder recorder(*context, gpu::bestTiming(context->info()));
    gpu::CommandBuffer& clear = recorder.pass("clear");
    clear.fill(counters, 0);
    clear.barrier(kTransferWrite, kComputeReadWrite);
    pass.record(recorder.pass("cull"), variant, mesh, transfer.support(), view, keys, counters);
    recorder.sync();
    return passSeconds(recorder, "cull");
  };
  cullSeconds();  // makes pipelines
  for ([[maybe_unused]] auto _ : state) state.SetIterationTime(cullSeconds());
  state.SetItemsProcessed(state.iterations() * mesh.cellCount());
}
BENCHMARK(cull)->Name("device/cull")->Unit(benchmark::kMillisecond)->UseManualTime();

// A whole frame of the default projection, 512 x 512 pixels.
void march(benchmark::State& state) {
  const gpu::Context* context = deviceFor(state);
  if (!context) return;
  render::RendererOptions options;
  options.projection = render::CellProjection::March;
  render::Renderer renderer(*context, gridMesh(), scalarField(gridMesh(), "", "bench"), options);
  renderer.setTransferFunction(gridTransfer());
  render::RenderOptions timed;
  timed.timed = true;
  renderer.draw(gridCamera(), {512, 512}, timed);  // makes pipelines and lists
  for ([[maybe_unused]] auto _ : state)
    state.SetIterationTime(1e-3 * renderer.draw(gridCamera(), {512, 512}, timed).frameMs);
  state.SetItemsProcessed(state.iterations() * 512 * 512);
}
BENCHMARK(march)->Name("device/march")->Unit(benchmark::kMillisecond)->UseManualTime();

}  // namespace
}  // namespace tetralux::bench
