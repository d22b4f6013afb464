#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_stats.h"

namespace tetralux::cli {
namespace {

class InfoCommand : public Command {
 public:
  explicit InfoCommand(CLI::App& app) {
    app.add_option("mesh", mesh_, "Mesh (.vtu, .vtk)")->required()->type_name("MESH");
    app.add_flag("--json", json_, "Print JSON");
  }

  int run() override {
    const MeshStats stats = computeMeshStats(readMesh(mesh_));
    json_ ? printJson(stats) : printText(stats);
    return 0;
  }

 private:
  static double edgeRatio(const MeshStats& s) { return s.shortestEdge > 0.0 ? s.longestEdge / s.shortestEdge : 0.0; }

  void printText(const MeshStats& s) const {
    fmt::print("{}\n", mesh_);
    fmt::print("cells             {}\n", s.cells);
    fmt::print("points            {} ({} of no cell)\n", s.points, s.unusedPoints);
    fmt::print("bounds            ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}), diagonal {:.6g}\n",
               s.bounds.low.x, s.bounds.low.y, s.bounds.low.z, s.bounds.high.x, s.bounds.high.y, s.bounds.high.z,
               s.bounds.diagonal());
    fmt::print("volume            {:.6g}\n", s.totalVolume);
    fmt::print("edge lengths      {:.6g} to {:.6g}, ratio {:.6g}\n", s.shortestEdge, s.longestEdge, edgeRatio(s));
    fmt::print("zero volume       {} cells ({} with a repeated vertex)\n", s.zeroVolumeCells, s.repeatedVertexCells);
    fmt::print("inverted          {} cells\n", s.invertedCells);
    fmt::print("duplicate         {} cells\n", s.duplicateCells);
    fmt::print("boundary faces    {}\n", s.boundaryFaces);
    fmt::print("interior faces    {}\n", s.interiorFaces);
    fmt::print("overused faces    {} (of more than two cells)\n", s.overusedFaces);
    for (const ArrayStats& a : s.arrays) {
      fmt::print("{} array       '{}' {}{}, {:.9g} to {:.9g}{}\n",
                 a.association == FieldAssociation::Point ? "point" : "cell ", a.name, a.type,
                 a.components == 1 ? "" : fmt::format(" x {} (length)", a.components), a.low, a.high,
                 a.nonFinite == 0 ? "" : fmt::format(", {} not finite", a.nonFinite));
    }
  }

  void printJson(const MeshStats& s) const {
    const auto vec = [](const glm::dvec3& v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
    nlohmann::ordered_json json;
    json["mesh"] = mesh_;
    json["cells"] = s.cells;
    json["points"] = s.points;
    json["unused_points"] = s.unusedPoints;
    json["bounds"] = {{"low", vec(s.bounds.low)}, {"high", vec(s.bounds.high)}, {"diagonal", s.bounds.diagonal()}};
    json["volume"] = s.totalVolume;
    json["edge_length"] = {{"shortest", s.shortestEdge}, {"longest", s.longestEdge}, {"ratio", edgeRatio(s)}};
    json["zero_volume_cells"] = s.zeroVolumeCells;
    json["repeated_vertex_cells"] = s.repeatedVertexCells;
    json["inverted_cells"] = s.invertedCells;
    json["duplicate_cells"] = s.duplicateCells;
    json["boundary_faces"] = s.boundaryFaces;
    json["interior_faces"] = s.interiorFaces;
    json["overused_faces"] = s.overusedFaces;
    json["arrays"] = nlohmann::ordered_json::array();
    for (const ArrayStats& a : s.arrays) {
      json["arrays"].push_back({{"name", a.name},
                                {"of", a.association == FieldAssociation::Point ? "points" : "cells"},
                                {"type", a.type},
                                {"components", a.components},
                                {"low", a.low},
                                {"high", a.high},
                                {"non_finite", a.nonFinite}});
    }
    fmt::print("{}\n", json.dump(1));
  }

  std::string mesh_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> makeInfoCommand(CLI::App& app) { return std::make_unique<InfoCommand>(app); }

}  // namespace tetralux::cli
