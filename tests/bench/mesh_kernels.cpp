// What is made of a mesh before it can be drawn.
#include "bench_device.h"
#include "mesh/boundary.h"
#include "mesh/cut_folds.h"
#include "mesh/random.h"

namespace tetralux::bench {
namespace {

void countCells(benchmark::State& state, size_t cells) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cells));
}

void adjacency(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(makeAdjacency(gridMesh()));
  countCells(state, gridMesh().cellCount());
}
BENCHMARK(adjacency)->Name("mesh/adjacency")->Unit(benchmark::kMillisecond)->UseRealTime();

void boundary(benchmark::State& state) {
  const Adjacency adjacency = makeAdjacency(gridMesh());
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(listBoundary(gridMesh(), adjacency));
  countCells(state, gridMesh().cellCount());
}
BENCHMARK(boundary)->Name("mesh/boundary")->Unit(benchmark::kMillisecond)->UseRealTime();

// Of a column that is twisted until a hundredth of its cells turn over.
void cutFoldedMesh(benchmark::State& state) {
  const TetMesh mesh = twistedDelaunay(5000, 1, 2.0);
  const Adjacency folded = makeAdjacency(mesh);
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    Adjacency cut = folded;
    state.ResumeTiming();
    cutFolds(mesh, cut);
    benchmark::DoNotOptimize(cut);
  }
  countCells(state, mesh.cellCount());
}
BENCHMARK(cutFoldedMesh)->Name("mesh/cut_folds")->Unit(benchmark::kMillisecond)->UseRealTime();

void delaunayOfRandomPoints(benchmark::State& state) {
  std::vector<glm::dvec3> points(5000);
  for (size_t i = 0; i < points.size(); i++)
    points[i] = {randomUnit(1, 3 * i), randomUnit(1, 3 * i + 1), randomUnit(1, 3 * i + 2)};
  size_t cells = 0;
  for ([[maybe_unused]] auto _ : state) {
    const TetMesh mesh = delaunay(points);
    cells = mesh.cellCount();
  }
  countCells(state, cells);
}
BENCHMARK(delaunayOfRandomPoints)->Name("mesh/delaunay")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace tetralux::bench
