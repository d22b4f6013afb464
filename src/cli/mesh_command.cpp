#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "mesh/curve_order.h"
#include "mesh/generate.h"
#include "mesh/mesh_io.h"

namespace tetralux::cli {
namespace {

struct MeshOptions {
  std::optional<std::uint64_t> cells;
  std::uint32_t seed = 1;
  std::optional<double> ratio;
  double turns = 0.5;
  double jitter = 0.1;
};

struct MeshKind {
  const char* name;
  const char* summary;
  std::uint64_t cells;  // default
  double ratio;         // default
  TetMesh (*make)(std::uint64_t cells, double ratio, const MeshOptions& options);
};

// Boxes along an edge of a cube of about so many cells, six to a box.
std::uint32_t boxesAlong(std::uint64_t cells) {
  return std::max(1u, static_cast<std::uint32_t>(std::lround(std::cbrt(static_cast<double>(cells) / 6.0))));
}

// Points of a random Delaunay mesh of about so many cells.
std::uint32_t pointsFor(std::uint64_t cells) {
  return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(cells / 6, 8, 1u << 30));
}

const glm::dvec3 kLow(0.0);
const glm::dvec3 kHigh(1.0);

const MeshKind kKinds[] = {
    {"demo", "electron wave function of a hydrogen atom (4d z2), graded Delaunay mesh of a ball", 250000, 0.0,
     [](std::uint64_t cells, double, const MeshOptions& o) { return hydrogenOrbital(cells, o.seed); }},
    {"box", "cubes cut into six cells each", 48000, 0.0,
     [](std::uint64_t cells, double, const MeshOptions&) {
       const std::uint32_t n = boxesAlong(cells);
       return kuhnGrid(n, n, n, kLow, kHigh, waveField);
     }},
    {"jittered", "the same with inner vertices moved by --jitter", 48000, 0.0,
     [](std::uint64_t cells, double, const MeshOptions& o) {
       const std::uint32_t n = boxesAlong(cells);
       return jitteredGrid(n, n, n, kLow, kHigh, o.jitter, o.seed, waveField);
     }},
    {"graded", "boxes whose edges grow by --ratio along each axis", 48000, 1e4,
     [](std::uint64_t cells, double ratio, const MeshOptions&) {
       return gradedBox(std::max(2u, boxesAlong(cells)), ratio);
     }},
    {"random", "Delaunay cells of random points", 50000, 0.0,
     [](std::uint64_t cells, double, const MeshOptions& o) { return randomDelaunay(pointsFor(cells), o.seed); }},
    {"flattened", "the same, z multiplied by --ratio afterwards", 50000, 0.1,
     [](std::uint64_t cells, double ratio, const MeshOptions& o) {
       return flattenedDelaunay(pointsFor(cells), o.seed, ratio);
     }},
    {"twisted", "a column of random Delaunay cells, twisted by --turns", 50000, 0.0,
     [](std::uint64_t cells, double, const MeshOptions& o) {
       return twistedDelaunay(pointsFor(cells), o.seed, o.turns);
     }},
    {"slivers", "a row of cells, each flatter than the last by --ratio", 20, 0.5,
     [](std::uint64_t cells, double ratio, const MeshOptions&) {
       return sliverChain(static_cast<std::uint32_t>(cells), ratio);
     }},
    {"cycle", "three cells that hide each other in a cycle along z", 3, 0.0,
     [](std::uint64_t, double, const MeshOptions&) { return cyclicTriple(); }},
    {"cycle-connected", "a convex mesh of 11 cells with such a cycle of nine", 11, 0.0,
     [](std::uint64_t, double, const MeshOptions&) { return cyclicOctahedron(); }},
};

class MeshCommand : public Command {
 public:
  explicit MeshCommand(CLI::App& app) {
    std::vector<std::string> names;
    std::string kinds = "Kinds:";
    for (const MeshKind& kind : kKinds) {
      names.emplace_back(kind.name);
      kinds += fmt::format("\n  {:<16} {}", kind.name, kind.summary);
    }
    app.footer(kinds);
    app.add_option("kind", kind_, "What to generate, see below")
        ->required()
        ->check(CLI::IsMember(names))
        ->type_name("KIND");
    app.add_option("-o,--output", output_, "Mesh to write")->required()->type_name("FILE.vtu");
    app.add_option("--cells", options_.cells, "About so many cells (default: by kind, 250000 for demo)")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1000000000}));
    app.add_option("--seed", options_.seed, "Of everything random (default: 1)");
    app.add_option("--ratio", options_.ratio,
                   "graded: longest edge through shortest; flattened: factor; slivers: heights")
        ->check(CLI::PositiveNumber);
    app.add_option("--turns", options_.turns, "twisted: full turns (default: 0.5)");
    app.add_option("--jitter", options_.jitter, "jittered: largest move in edges (default: 0.1)")
        ->check(CLI::Range(0.0, 0.16));
    app.add_option("--field-function", fieldFunction_,
                   "sphere: adds the distance from the middle of the mesh's box, as array 'distance', and prefers it")
        ->check(CLI::IsMember({"sphere"}))
        ->type_name("FUNCTION");
    app.add_flag("--shuffle", shuffle_, "Points and cells in random order, as some programs write them");
    app.add_flag("--uncompressed", uncompressed_, "Raw numbers in the file: larger, quicker to read");
    addQuiet(app);
  }

  int run() override {
    checkOutputName();
    const MeshKind& kind =
        *std::find_if(std::begin(kKinds), std::end(kKinds), [&](const MeshKind& k) { return k.name == kind_; });
    const double ratio = options_.ratio.value_or(kind.ratio);
    checkRatio(ratio);
    TetMesh mesh = kind.make(options_.cells.value_or(kind.cells), ratio, options_);
    if (fieldFunction_ == "sphere") addPreferredField(mesh, "distance", distanceField(mesh.bounds().center()));
    if (shuffle_) shuffle(mesh, options_.seed);
    VtuWriteOptions options;
    options.compress = !uncompressed_;
    writeVtu(mesh, output_, options);
    spdlog::info("wrote {}: {} cells, {} points", output_, mesh.cellCount(), mesh.pointCount());
    return 0;
  }

 private:
  void checkOutputName() const {
    if (!output_.ends_with(".vtu"))
      fail(ErrorCode::Usage, "-o: found '{}', expected a name that ends in .vtu", output_);
  }

  void checkRatio(double ratio) const {
    if (kind_ == "graded" && !(ratio >= 1.0)) fail(ErrorCode::Usage, "--ratio: found {}, expected at least 1", ratio);
    if (kind_ == "slivers" && !(ratio < 1.0)) fail(ErrorCode::Usage, "--ratio: found {}, expected less than 1", ratio);
    if (kind_ == "demo" && options_.cells.value_or(1000) < 1000)
      fail(ErrorCode::Usage, "--cells: found {}, expected at least 1000 for the demo", *options_.cells);
  }

  std::string kind_;
  std::string output_;
  std::string fieldFunction_;
  MeshOptions options_;
  bool shuffle_ = false;
  bool uncompressed_ = false;
};

}  // namespace

std::unique_ptr<Command> makeMeshCommand(CLI::App& app) { return std::make_unique<MeshCommand>(app); }

}  // namespace tetralux::cli
