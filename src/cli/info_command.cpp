#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/load_scene.h"
#include "cli/order_table.h"
#include "cli/stats_json.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_stats.h"

namespace tetralux::cli {
namespace {

class InfoCommand : public Command {
 public:
  explicit InfoCommand(CLI::App& app) {
    app.add_option("input", input_, "Mesh (.vtu, .vtk) or scene (.json)")->required()->type_name("MESH|SCENE");
    app.add_flag("--json", json_, "Print JSON");
    app.add_flag("--orders", orders_,
                 "Draw the view in every order, and report what each gets wrong and what it costs");
    app.add_option("--frames", frames_, "Frames of which --orders reports the median time (default: 3)")
        ->check(CLI::Range(1u, 1000u));
    sceneOptions_.add(app);
    deviceOptions_.add(app);
    addQuiet(app);
  }

  int run() override {
    // Without a view there need not be a field to draw.
    LoadedScene loaded;
    if (deviceOptions_.projection == "auto") deviceOptions_.projection = "pt";
    if (orders_ && deviceOptions_.projection == "march")
      fail(ErrorCode::Usage,
           "--orders: found '--projection march', expected pt, silhouette or gator: rays need no order");
    if (orders_)
      loaded = loadScene(input_, sceneOptions_);
    else
      loaded.mesh = readMesh(isSceneFile(input_) ? readScene(input_).meshPath : std::filesystem::path(input_));
    const MeshStats stats = computeMeshStats(loaded.mesh);
    std::vector<OrderRow> rows;
    if (orders_) {
      const gpu::Context context(deviceOptions_.contextOptions());
      rows = orderTable(context, loaded, deviceOptions_.rendererOptions(), deviceOptions_.renderOptions(), frames_);
      failOnValidationMessages();
    }
    json_ ? printJson(stats, rows) : printText(stats, rows);
    return 0;
  }

 private:
  static double edgeRatio(const MeshStats& s) { return s.shortestEdge > 0.0 ? s.longestEdge / s.shortestEdge : 0.0; }

  void printText(const MeshStats& s, const std::vector<OrderRow>& rows) const {
    fmt::print("{}\n", input_);
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
    if (!rows.empty())
      fmt::print("{:<9} {:<8} {:>6} {:>10} {:>10} {:>10} {:>10} {:>8} {:>8} {:>9} {:>9}\n", "order", "drawn", "exact",
                 "faces", "misordered", "gaps", "misordered", "cyclic", "short px", "order ms", "frame ms");
    for (const OrderRow& row : rows) {
      const render::OrderReport& r = row.report;
      fmt::print("{:<9} {:<8} {:>6} {:>10} {:>10} {:>10} {:>10} {:>8} {:>8} {:>9.2f} {:>9.2f}\n",
                 render::orderName(row.asked), render::orderName(r.order), r.isExact() ? "yes" : "no", r.faces,
                 r.misordered, r.relations, r.misorderedRelations, r.cyclicCells, r.shortPixels, row.orderMs,
                 row.frameMs);
    }
  }

  void printJson(const MeshStats& s, const std::vector<OrderRow>& rows) const {
    const auto vec = [](const glm::dvec3& v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
    nlohmann::ordered_json json;
    json["mesh"] = input_;
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
    for (const OrderRow& row : rows) {
      nlohmann::ordered_json order = {{"order", render::orderName(row.asked)},
                                      {"drawn", render::orderName(row.report.order)}};
      order.update(orderJson(row.report));
      order["order_ms"] = row.orderMs;
      order["frame_ms"] = row.frameMs;
      json["orders"].push_back(order);
    }
    fmt::print("{}\n", json.dump(1));
  }

  std::string input_;
  bool json_ = false;
  bool orders_ = false;
  std::uint32_t frames_ = 3;
  SceneOptions sceneOptions_;
  DeviceOptions deviceOptions_;
};

}  // namespace

std::unique_ptr<Command> makeInfoCommand(CLI::App& app) { return std::make_unique<InfoCommand>(app); }

}  // namespace tetralux::cli
