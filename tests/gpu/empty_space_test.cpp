// Empty-space skipping: what is cut out of a mesh against the rule for it, and pictures of what is left.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "appearance_views.h"
#include "fields/appearance_data.h"
#include "gpu_fixture.h"
#include "mesh/cut_folds.h"
#include "mesh/generate.h"
#include "mesh/vertex_buckets.h"
#include "order_views.h"
#include "projection_views.h"
#include "render/empty_space.h"

namespace tetralux::render {
namespace {

using test::GpuTest;

// Shows around the middle of a field's range only.
TransferFunction peak(const ScalarField& field, double at = 0.5, double width = 0.05) {
  const auto scalar = [&](double share) { return field.low + share * (field.high - field.low); };
  return TransferFunction({{scalar(0.0), {1, 0.5, 0}, 0.0},
                           {scalar(at - width), {1, 0.5, 0}, 0.0},
                           {scalar(at), {0, 0.5, 1}, 20.0},
                           {scalar(at + width), {1, 0, 0.5}, 0.0},
                           {scalar(1.0), {1, 0, 0.5}, 0.0}},
                          "peak");
}

RendererOptions walking(std::optional<bool> skip) {
  RendererOptions options = test::withProjection(CellProjection::March);
  options.skipEmptySpace = skip;
  return options;
}

// A topology on the host: neighbours with their vertices, and boundary faces without their order.
struct HostTopology {
  std::vector<std::array<std::uint32_t, 2>> across;  // four per cell
  std::multiset<std::array<std::uint32_t, 4>> faces;
  std::uint32_t cells = 0;  // that have not been cut out
};

HostTopology topologyOn(const gpu::Context& context, const WalkTopology& topology, std::uint32_t cells) {
  HostTopology host;
  for (const gpu::Buffer& piece : topology.acrossBuffer().pieces()) {
    const auto part = gpu::downloadVector<std::array<std::uint32_t, 2>>(context, piece, piece.sizeBytes() / 8);
    host.across.insert(host.across.end(), part.begin(), part.end());
  }
  EXPECT_EQ(host.across.size(), 4 * size_t{cells});
  for (const auto& face :
       gpu::downloadVector<std::array<std::uint32_t, 4>>(context, topology.boundaryBuffer(), topology.boundaryCount()))
    host.faces.insert(face);
  return host;
}

// Cut out of a mesh by the device.
HostTopology cutByDevice(const gpu::Context& context, const TetMesh& mesh, const Adjacency& adjacency,
                         const TransferFunction& transfer, bool wideAddressing = false) {
  const ScalarField field = scalarField(mesh, "", "test");
  const unsigned pieceBits = wideAddressing ? 8 : gpu::kPieceBits;
  const GpuMesh gpuMesh(context, mesh, field, pieceBits);
  const TransferBuffer buffer(context, transfer, gpuMesh.space());
  const WalkTopology whole(context, mesh, adjacency, pieceBits);
  EmptySpace emptySpace(context, /*forced=*/true);
  gpu::Recorder recorder(context, gpu::PassTiming::Off);
  emptySpace.find(recorder, {gpuMesh, whole, buffer.support(), buffer.supportCount(), false, wideAddressing});
  EXPECT_NE(emptySpace.kept(), nullptr);
  HostTopology host = topologyOn(context, *emptySpace.kept(), gpuMesh.cellCount());
  host.cells = gpuMesh.cellCount() - emptySpace.cutCells();
  return host;
}

// The same by the rule, from cells that show.
HostTopology cutByRule(const TetMesh& mesh, const Adjacency& adjacency, const std::vector<bool>& shows) {
  const auto cells = static_cast<std::uint32_t>(mesh.cellCount());
  std::vector<bool> kept = shows;
  for (std::uint32_t cell = 0; cell < cells; cell++) {
    const auto& neighbors = adjacency.neighbors[cell];
    const auto showing = std::count_if(neighbors.begin(), neighbors.end(),
                                       [&](std::uint32_t next) { return next != kNoCell && shows[next]; });
    if (showing >= 2) kept[cell] = true;
  }
  HostTopology host;
  for (std::uint32_t cell = 0; cell < cells; cell++) {
    if (kept[cell]) host.cells++;
    const CellVertices v = sortedVertices(mesh.cells[cell]);
    for (std::uint32_t k = 0; k < 4; k++) {
      const std::uint32_t next = adjacency.neighbors[cell][k];
      const bool isOpen = next != kNoCell && kept[next];
      std::uint32_t opposite = 0;
      if (isOpen) {
        const CellVertices beyond = sortedVertices(mesh.cells[next]);
        opposite = *std::find_if(beyond.begin(), beyond.end(), [&](std::uint32_t vertex) {
          return vertex == v[k] || std::find(v.begin(), v.end(), vertex) == v.end();
        });
      }
      host.across.push_back({isOpen ? next : kNoCell, opposite});
      if (!kept[cell] || isOpen) continue;
      std::array<std::uint32_t, 4> face{v[k == 0 ? 1 : 0], v[k <= 1 ? 2 : 1], v[k <= 2 ? 3 : 2], 4 * cell + k};
      if ((adjacency.sides[cell] >> k & 1) != 0) std::swap(face[1], face[2]);
      host.faces.insert(face);
    }
  }
  return host;
}

std::vector<bool> showing(const TetMesh& mesh, const ScalarField& field, double low, double high) {
  std::vector<bool> shows;
  for (const CellVertices& cell : mesh.cells) {
    const CellVertices v = sortedVertices(cell);
    double least = field.values[v[0]];
    double most = least;
    for (const std::uint32_t vertex : v) {
      least = std::min(least, field.values[vertex]);
      most = std::max(most, field.values[vertex]);
    }
    shows.push_back(!hasRepeatedVertex(v) && least < high && most > low);
  }
  return shows;
}

// Neighbours of cells that were cut out are whatever they were: no ray gets there.
void expectSame(const HostTopology& expected, const HostTopology& found, const std::vector<bool>& isReached) {
  EXPECT_EQ(expected.cells, found.cells);
  EXPECT_EQ(expected.faces, found.faces);
  ASSERT_EQ(expected.across.size(), found.across.size());
  size_t differences = 0;
  for (size_t i = 0; i < expected.across.size(); i++) {
    if (!isReached[i / 4] || expected.across[i][0] == kNoCell)
      differences += isReached[i / 4] && found.across[i][0] != kNoCell ? 1 : 0;
    else
      differences += expected.across[i] != found.across[i] ? 1 : 0;
  }
  EXPECT_EQ(differences, 0u);
}

TEST_F(GpuTest, CutMeshesHaveTheCellsThatShowAndTheSurfaceAroundThem) {
  for (TetMesh mesh : {randomDelaunay(2000, 7), twistedDelaunay(800, 1, 0.7),
                       kuhnGrid(9, 8, 7, glm::dvec3(0), glm::dvec3(1), waveField)}) {
    // Cells that are nowhere, and cells that are there twice.
    mesh.cells.push_back({1, 2, 2, 3});
    mesh.cells.push_back(mesh.cells[5]);
    const ScalarField field = scalarField(mesh, "", "test");
    Adjacency adjacency = makeAdjacency(mesh);
    cutFolds(mesh, adjacency);
    const double middle = 0.5 * (field.low + field.high);
    const double width = 0.05 * (field.high - field.low);
    const std::vector<bool> shows = showing(mesh, field, middle - width, middle + width);
    ASSERT_GT(std::count(shows.begin(), shows.end(), true), 100);
    ASSERT_GT(std::count(shows.begin(), shows.end(), false), 100);
    for (const bool wideAddressing : {false, true})
      expectSame(cutByRule(mesh, adjacency, shows),
                 cutByDevice(context(), mesh, adjacency, peak(field), wideAddressing), shows);
  }
}

// Where everything shows, what is left is what the host makes of the whole mesh.
TEST_F(GpuTest, CuttingNothingLeavesTheMeshAsItIs) {
  for (const TetMesh& mesh : {randomDelaunay(1000, 3), twistedDelaunay(800, 1, 0.7)}) {
    Adjacency adjacency = makeAdjacency(mesh);
    cutFolds(mesh, adjacency);
    const TransferFunction everywhere({{0.0, {1, 1, 1}, 1.0}}, "test");
    const HostTopology cut = cutByDevice(context(), mesh, adjacency, everywhere);
    const HostTopology whole =
        topologyOn(context(), WalkTopology(context(), mesh, adjacency), static_cast<std::uint32_t>(mesh.cellCount()));
    EXPECT_EQ(cut.cells, mesh.cellCount());
    EXPECT_TRUE(cut.faces == whole.faces);
    EXPECT_TRUE(cut.across == whole.across);
  }
}

TEST_F(GpuTest, PicturesOfCutMeshesAgreeWithTheReference) {
  std::vector<test::NamedMesh> meshes = test::hardMeshes();
  meshes.push_back({"twisted", twistedDelaunay(800, 1, 0.7)});
  std::uint64_t cut = 0;
  for (const auto& [name, mesh] : meshes) {
    const ScalarField field = scalarField(mesh, "", "test");
    for (const Camera& camera : test::orderViews(mesh)) {
      for (const bool isDouble : {false, true}) {
        if (isDouble && !context().info().hasFloat64) continue;
        RendererOptions options = walking(true);
        options.doublePrecision = isDouble;
        Renderer renderer(context(), mesh, field, options);
        renderer.setTransferFunction(peak(field));
        cut += renderer.draw(camera, test::kOrderSize).culledTransparent;
        const ImageDifference d = compareImages(test::exactImage(mesh, peak(field), camera), renderer.readImage());
        EXPECT_LE(d.rmse, 2e-5) << name;
        EXPECT_LE(d.max, 1.0 / 510.0) << name;
      }
    }
  }
  EXPECT_GT(cut, 1000u);
}

TEST_F(GpuTest, IsosurfacesAloneAreDrawnFromTheCellsThatTheyCross) {
  const TetMesh mesh = randomDelaunay(4000, 7);
  const ScalarField field = scalarField(mesh, "", "test");
  Appearance appearance;
  appearance.volumeVisible = false;
  appearance.isosurfaces = {test::surfaceAt(field.low + 0.4 * (field.high - field.low), 0.5),
                            test::surfaceAt(field.low + 0.6 * (field.high - field.low), 1.0)};
  const AppearanceData data = makeAppearanceData(appearance, mesh, field, "test");
  for (const Camera& camera : test::orderViews(mesh)) {
    Image images[2];
    for (const bool skip : {false, true}) {
      Renderer renderer(context(), mesh, field, walking(skip));
      renderer.setTransferFunction(test::orderTransfer());
      renderer.setAppearance(appearance, data);
      const FrameStats stats = renderer.draw(camera, test::kOrderSize);
      if (skip)
        EXPECT_GT(stats.culledTransparent, mesh.cellCount() / 4);
      else
        EXPECT_EQ(stats.culledTransparent, 0u);
      images[skip] = renderer.readImage();
    }
    const ImageDifference d = compareImages(images[0], images[1]);
    EXPECT_LE(d.rmse, 2e-5);
  }
}

TEST_F(GpuTest, NothingShowsIsAnEmptyPicture) {
  const TetMesh mesh = randomDelaunay(500, 7);
  Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), walking({}));
  renderer.setTransferFunction(TransferFunction({{0.0, {1, 1, 1}, 0.0}}, "nothing"));
  const FrameStats stats = renderer.draw(test::orderViews(mesh)[0], test::kOrderSize);
  EXPECT_EQ(stats.culledTransparent, mesh.cellCount());
  for (const glm::vec4& pixel : renderer.readImage().pixels) EXPECT_EQ(pixel, glm::vec4(0.0f));
}

// A transfer function that may be the last is looked at; one that follows another when it is drawn again.
TEST_F(GpuTest, EmptySpaceIsCutOncePerTransferFunction) {
  const TetMesh mesh = randomDelaunay(3000, 7);
  const ScalarField field = scalarField(mesh, "", "test");
  const Camera camera = test::orderViews(mesh)[0];
  Renderer renderer(context(), mesh, field, walking(true));
  const auto draw = [&] {
    RenderOptions options;
    options.timed = true;
    const FrameStats stats = renderer.draw(camera, test::kOrderSize, options);
    const bool looked = std::any_of(stats.passes.begin(), stats.passes.end(),
                                    [](const gpu::PassTime& pass) { return pass.name == "skip"; });
    return std::pair{looked, stats.culledTransparent > 0};
  };
  renderer.setTransferFunction(peak(field));
  EXPECT_EQ(draw(), std::pair(true, true));
  EXPECT_EQ(draw(), std::pair(false, true));
  const Image first = renderer.readImage();
  renderer.setTransferFunction(peak(field, 0.7));
  EXPECT_EQ(draw(), std::pair(false, false));
  const Image whole = renderer.readImage();
  EXPECT_EQ(draw(), std::pair(true, true));
  EXPECT_LE(compareImages(whole, renderer.readImage()).rmse, 1e-6);
  // Methods with tables get all cells.
  RenderOptions method;
  method.integration = Integration::Preint3d;
  EXPECT_EQ(renderer.draw(camera, test::kOrderSize, method).culledTransparent, 0u);
  renderer.setTransferFunction(peak(field));
  draw();
  draw();
  EXPECT_EQ(renderer.readImage().pixels, first.pixels);
}

// One picture of a mesh with many more cells than it has pixels does not wait either.
TEST_F(GpuTest, EmptySpaceOfLargeMeshesIsCutForTheSecondPicture) {
  const TetMesh mesh = randomDelaunay(3000, 7);
  const ScalarField field = scalarField(mesh, "", "test");
  Renderer renderer(context(), mesh, field, walking(true));
  renderer.setTransferFunction(peak(field));
  const Camera camera = test::orderViews(mesh)[0];
  EXPECT_EQ(renderer.draw(camera, {16, 12}).culledTransparent, 0u);
  const Image whole = renderer.readImage();
  EXPECT_GT(renderer.draw(camera, {16, 12}).culledTransparent, 1000u);
  EXPECT_LE(compareImages(whole, renderer.readImage()).rmse, 1e-6);
}

TEST_F(GpuTest, FramesInFlightAreCutTheSame) {
  const TetMesh mesh = randomDelaunay(3000, 7);
  const ScalarField field = scalarField(mesh, "", "test");
  const Camera camera = test::orderViews(mesh)[0];
  const auto turned = [&](int i) { return camera.turned(15.0 * i); };
  constexpr int kFrames = 6;
  Renderer alone(context(), mesh, field, walking(true));
  Renderer ahead(context(), mesh, field, walking(true));
  for (const double at : {0.5, 0.7}) {
    alone.setTransferFunction(peak(field, at));
    ahead.setTransferFunction(peak(field, at));
    std::vector<Renderer::Finished> finished;
    for (int i = 0; i < kFrames; i++) {
      ahead.begin(turned(i), test::kOrderSize);
      if (ahead.inFlight() > 2) finished.push_back(ahead.finish());
    }
    while (ahead.inFlight() > 0) finished.push_back(ahead.finish());
    for (int i = 0; i < kFrames; i++) {
      const FrameStats stats = alone.draw(turned(i), test::kOrderSize);
      EXPECT_EQ(stats.culledTransparent, finished[static_cast<size_t>(i)].stats.culledTransparent) << i;
      EXPECT_TRUE(alone.readImage().pixels == finished[static_cast<size_t>(i)].image.pixels) << i;
    }
  }
}

TEST(EmptySpace, CuttingPaysByStepsSavedPerReturn) {
  EXPECT_FALSE(paysToCut(100'000, 5'000, 100'000, 5'000));  // nothing to cut
  EXPECT_FALSE(paysToCut(100'000, 5'000, 99'000, 5'000));   // too little
  EXPECT_TRUE(paysToCut(100'000, 5'000, 50'000, 4'000));    // half of it, and a smaller surface
  EXPECT_FALSE(paysToCut(100'000, 5'000, 50'000, 25'000));  // crumbs
  EXPECT_TRUE(paysToCut(100'000, 5'000, 50'000, 9'000));
}

}  // namespace
}  // namespace tetralux::render
