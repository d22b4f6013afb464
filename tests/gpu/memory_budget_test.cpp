// What does not fit is refused before anything is allocated.
#include "gpu/memory_budget.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"
#include "render/memory_need.h"
#include "support/expect_error.h"

namespace tetralux::render {
namespace {

using test::GpuTest;
using ::testing::HasSubstr;

gpu::Context contextWith(std::uint64_t availableBytes) {
  gpu::ContextOptions options;
  options.availableBytes = availableBytes;
  return gpu::Context(options);
}

TEST_F(GpuTest, MemoryBudgetIsWithinTheHeap) {
  const gpu::MemoryBudget budget = context().memoryBudget();
  EXPECT_GT(budget.heapBytes, 0u);
  EXPECT_GT(budget.availableBytes, 0u);
  EXPECT_LE(budget.availableBytes, budget.heapBytes);
  EXPECT_EQ(budget.heapBytes, context().info().memory.heapBytes);
}

TEST_F(GpuTest, MemoryThatIsThereMayBeTakenToTheLastByte) {
  const gpu::Context small = contextWith(1000);
  gpu::requireMemory(small, 1000, "a list");
  EXPECT_EQ(test::errorOf(ErrorCode::Device, [&] { gpu::requireMemory(small, 1001, "a list"); }),
            fmt::format("out of memory: a list needs 1001 bytes, device '{}' has 1000 available", small.info().name));
}

// What is reckoned beforehand is never more than what is taken, and nearly all of it.
TEST_F(GpuTest, MeshNeedsWhatWasReckoned) {
  TetMesh mesh = jitteredGrid(12, 12, 12, glm::dvec3(0), glm::dvec3(1), 0.1, 1, waveField);
  std::vector<float> perCell(mesh.cellCount());
  for (size_t i = 0; i < perCell.size(); i++) perCell[i] = static_cast<float>(i % 7);
  mesh.cellArrays.push_back({"c", 1, perCell});
  for (const char* name : {"scalar", "c"}) {
    const ScalarField field = scalarField(mesh, name, "test");
    for (const CellProjection projection :
         {CellProjection::March, CellProjection::Pt, CellProjection::Silhouette, CellProjection::Gator}) {
      RendererOptions options = test::withProjection(projection);
      options.order = Order::Radix;
      const Renderer renderer(context(), mesh, field, options);
      const MemoryUse use = renderer.memoryUse();
      const std::uint64_t taken = use.meshBytes + use.frameBytes + use.orderBytes;
      const std::uint64_t reckoned = leastMeshBytes(mesh.cellCount(), mesh.pointCount(), field.association, projection,
                                                    context().info().hasFloat64);
      EXPECT_LE(reckoned, taken) << name << " " << projectionName(projection);
      EXPECT_GE(static_cast<double>(reckoned), 0.7 * static_cast<double>(taken))
          << name << " " << projectionName(projection);
    }
  }
}

TEST_F(GpuTest, MeshesThatDoNotFitAreRefused) {
  const TetMesh mesh = randomDelaunay(300, 1);
  const ScalarField field = scalarField(mesh, "", "test");
  const std::uint64_t needed = leastMeshBytes(mesh.cellCount(), mesh.pointCount(), field.association,
                                              CellProjection::March, context().info().hasFloat64);
  const RendererOptions march = test::withProjection(CellProjection::March);
  {
    const gpu::Context small = contextWith(needed - 1);
    const std::string message =
        test::errorOf(ErrorCode::Device, [&] { const Renderer renderer(small, mesh, field, march); });
    EXPECT_THAT(message, HasSubstr(fmt::format("a mesh of {} cells needs {} bytes", mesh.cellCount(), needed)));
    EXPECT_THAT(message, HasSubstr(fmt::format("has {} available", needed - 1)));
  }
  const gpu::Context enough = contextWith(needed);
  EXPECT_EQ(Renderer(enough, mesh, field, march).cellCount(), mesh.cellCount());
}

// The mesh fits, the picture's lists do not; a smaller picture can still be drawn.
TEST_F(GpuTest, PicturesThatDoNotFitAreRefused) {
  const TetMesh mesh = randomDelaunay(300, 1);
  const gpu::Context small = contextWith(4 << 20);
  Renderer renderer(small, mesh, scalarField(mesh, "", "test"), test::withProjection(CellProjection::March));
  renderer.setTransferFunction(test::orderTransfer());
  const Camera camera = test::orderViews(mesh)[0];
  renderer.draw(camera, {64, 48});
  const std::string message = test::errorOf(ErrorCode::Device, [&] { renderer.draw(camera, {2000, 1500}); });
  EXPECT_THAT(message, HasSubstr("out of memory: the picture needs 48000000 bytes"));
  renderer.draw(camera, {64, 48});
}

}  // namespace
}  // namespace tetralux::render
