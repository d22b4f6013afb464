// VTK XML polygonal data (.vtp).
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <limits>
#include <type_traits>

#include "base/error.h"
#include "mesh/triangle_soup.h"
#include "mesh/vtk_assemble.h"
#include "mesh/vtk_text.h"
#include "mesh/vtk_types.h"
#include "mesh/vtk_xml_file.h"

namespace tetralux {
namespace {

struct Piece {
  pugi::xml_node element;
  size_t firstPoint = 0;  // in the soup
  size_t points = 0;
  std::string place;
};

// Whole numbers; those beyond 64 bits with a sign become negative.
std::vector<std::int64_t> integers(const ArrayValues& values, const std::string& place) {
  return std::visit(
      [&](const auto& v) {
        using T = typename std::decay_t<decltype(v)>::value_type;
        if constexpr (std::is_floating_point_v<T>)
          fail(ErrorCode::Input, "{}: type is {}, expected an integer type", place,
               std::is_same_v<T, float> ? "Float32" : "Float64");
        return std::vector<std::int64_t>(v.begin(), v.end());
      },
      values);
}

pugi::xml_node arrayNamed(pugi::xml_node group, const char* name, const std::string& place) {
  const pugi::xml_node array = group.find_child_by_attribute("DataArray", "Name", name);
  if (!array) fail(ErrorCode::Input, "{}: no array '{}', expected one", place, name);
  return array;
}

void readPoints(const VtkXmlFile& file, const Piece& piece, TriangleSoup& soup) {
  const std::string place = piece.place + ": Points";
  const pugi::xml_node array = piece.element.child("Points").child("DataArray");
  if (!array) fail(ErrorCode::Input, "{}: no DataArray, expected one", place);
  const ArrayValues coordinates = file.values(array, 3 * piece.points, place);
  std::visit(
      [&](const auto& v) {
        for (size_t i = 0; i + 2 < v.size(); i += 3)
          soup.points.emplace_back(static_cast<double>(v[i]), static_cast<double>(v[i + 1]),
                                   static_cast<double>(v[i + 2]));
      },
      coordinates);
}

std::uint64_t optionalCount(const Piece& piece, const char* name) {
  return piece.element.attribute(name) ? countAttribute(piece.element, name, piece.place) : 0;
}

// Calls visitor(vertices, place) for every cell of "Polys" or "Strips".
template <typename Visitor>
void forEachCell(const VtkXmlFile& file, const Piece& piece, const char* group, const char* countName,
                 const Visitor& visitor) {
  const std::uint64_t count = optionalCount(piece, countName);
  if (count == 0) return;
  const pugi::xml_node cells = piece.element.child(group);
  const std::string place = fmt::format("{}: {}", piece.place, group);
  const std::string endsPlace = place + ": offsets";
  const auto ends = integers(file.values(arrayNamed(cells, "offsets", place), count, endsPlace), endsPlace);
  std::int64_t end = 0;
  for (size_t i = 0; i < ends.size(); i++) {
    if (ends[i] < end)
      fail(ErrorCode::Input, "{}: cell {}: ends after vertex {} of the connectivity, expected at least {}", place, i,
           ends[i], end);
    end = ends[i];
  }
  const std::string verticesPlace = place + ": connectivity";
  const auto vertices = integers(
      file.values(arrayNamed(cells, "connectivity", place), static_cast<size_t>(end), verticesPlace), verticesPlace);
  size_t begin = 0;
  for (size_t i = 0; i < ends.size(); i++) {
    const auto size = static_cast<size_t>(ends[i]) - begin;
    visitor(std::span(vertices).subspan(begin, size), fmt::format("{}: cell {}", place, i));
    begin += size;
  }
}

void readPiece(const VtkXmlFile& file, const Piece& piece, TriangleSoup& soup) {
  readPoints(file, piece, soup);
  const auto append = [&](std::span<const std::int64_t> polygon, const std::string& place) {
    appendPolygon(soup, polygon, piece.firstPoint, piece.points, place);
  };
  forEachCell(file, piece, "Polys", "NumberOfPolys", append);
  forEachCell(file, piece, "Strips", "NumberOfStrips",
              [&](std::span<const std::int64_t> strip, const std::string& place) {
                if (strip.size() < 3) append(strip, place);  // complains
                for (size_t k = 0; k + 2 < strip.size(); k++) {
                  // Every other triangle of a strip is turned round.
                  const size_t odd = k % 2;
                  append(std::array{strip[k + odd], strip[k + 1 - odd], strip[k + 2]}, place);
                }
              });
}

}  // namespace

TriangleSoup readVtp(const std::filesystem::path& path) {
  const VtkXmlFile file(path, "PolyData");
  TriangleSoup soup;
  std::uint64_t others = 0;
  size_t index = 0;
  for (const pugi::xml_node element : file.dataSet().children("Piece")) {
    Piece piece{element, soup.points.size(), 0, fmt::format("{}: piece {}", file.name(), index++)};
    piece.points = countAttribute(element, "NumberOfPoints", piece.place);
    checkPointCount(piece.points, piece.place);
    checkPointCount(soup.points.size() + piece.points, piece.place);
    others += optionalCount(piece, "NumberOfVerts") + optionalCount(piece, "NumberOfLines");
    if (piece.points > 0) readPiece(file, piece, soup);
  }
  if (others > 0) spdlog::warn("{}: {} vertices and lines are left out", oneLine(file.name()), others);
  return soup;
}

}  // namespace tetralux
