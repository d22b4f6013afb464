// Kernels timed one by one, by Google Benchmark. Names are stable, so that measurements of different commits compare: a
// kernel that does other work than before gets another name.
#include <benchmark/benchmark.h>

#include "bench_device.h"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  if (const tetralux::gpu::Context* device = tetralux::bench::device()) {
    benchmark::AddCustomContext("device", device->info().name);
    benchmark::AddCustomContext("driver", device->info().driver);
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  tetralux::bench::releaseDevice();
  return 0;
}
