// Transfer functions and light along a ray, on the processor.
#include <cmath>

#include "bench_device.h"
#include "reference/segment_integral.h"
#include "render/transfer_buffer.h"

namespace tetralux::bench {
namespace {

// A peak of a hundredth of the range every fiftieth.
TransferFunction combTransfer() {
  std::vector<ControlPoint> points;
  for (int i = 0; i < 50; i++) {
    const double s = -1.0 + 0.04 * i;
    points.push_back({s, glm::dvec3(0.2), 0.1});
    points.push_back({s + 0.01, glm::dvec3(0.9), 20.0});
    points.push_back({s + 0.02, glm::dvec3(0.2), 0.1});
  }
  return {points, "bench"};
}

void transferTables(benchmark::State& state) {
  const TransferFunction transfer = combTransfer();
  render::MeshSpace space;
  space.scalarRange = 2.0;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(render::makeTransferTables(transfer, space));
}
BENCHMARK(transferTables)->Name("render/transfer_tables")->Unit(benchmark::kMicrosecond);

// Segments of all rises within the range, through one to twenty pieces.
void referenceSegment(benchmark::State& state) {
  const TransferFunction transfer = combTransfer();
  double phase = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    phase += 0.618033988749895;
    const double front = std::sin(phase);
    benchmark::DoNotOptimize(reference::integrateSegment(transfer, front, front + 0.2 * std::cos(7.0 * phase), 0.1));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(referenceSegment)->Name("reference/segment_integral")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tetralux::bench
