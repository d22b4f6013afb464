// Wavefront .obj files: points and faces, one a line.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "base/error.h"
#include "base/files.h"
#include "mesh/triangle_soup.h"
#include "mesh/vtk_assemble.h"
#include "mesh/vtk_text.h"

namespace tetralux {
namespace {

glm::dvec3 parsePoint(TextScanner& words, const std::string& place) {
  glm::dvec3 point;
  for (int axis = 0; axis < 3; axis++) {
    const std::string_view word = words.word();
    if (!parseNumber(word, point[axis]))
      fail(ErrorCode::Input, "{}: coordinate {} is '{}', expected a number", place, "xyz"[axis], excerpt(word));
  }
  return point;
}

// Index of a point from 0, of a corner "7", "7/1", "7//3", "7/1/3" or "-1", the last point so far.
std::int64_t parseCorner(std::string_view word, size_t pointsSoFar, const std::string& place) {
  std::int64_t number = 0;
  if (!parseNumber(word.substr(0, word.find('/')), number) || number == 0)
    fail(ErrorCode::Input, "{}: corner '{}', expected the number of a point", place, excerpt(word));
  const auto count = static_cast<std::int64_t>(pointsSoFar);
  if (number < -count)
    fail(ErrorCode::Input, "{}: corner '{}', expected one of the {} points before it", place, excerpt(word), count);
  return number > 0 ? number - 1 : count + number;
}

}  // namespace

TriangleSoup readObj(const std::filesystem::path& path) {
  const std::string file = readTextFile(path);
  TriangleSoup soup;
  struct Face {
    size_t line;
    size_t corners;
  };
  // Points may come after the faces that have them.
  std::vector<Face> faces;
  std::vector<std::int64_t> corners;
  size_t others = 0;
  TextScanner lines(file);
  for (size_t number = 1; !lines.atEnd(); number++) {
    TextScanner words(lines.line());
    const std::string_view keyword = words.word();
    if (keyword == "v") {
      soup.points.push_back(parsePoint(words, fmt::format("{}: line {}", path.string(), number)));
      checkPointCount(soup.points.size(), path.string());
    } else if (keyword == "f") {
      const std::string place = fmt::format("{}: line {}", path.string(), number);
      const size_t before = corners.size();
      for (std::string_view word = words.word(); !word.empty(); word = words.word())
        corners.push_back(parseCorner(word, soup.points.size(), place));
      faces.push_back({number, corners.size() - before});
    } else if (keyword == "l" || keyword == "p") {
      others++;
    }
  }
  std::span<const std::int64_t> rest = corners;
  for (const Face& face : faces) {
    appendPolygon(soup, rest.first(face.corners), 0, soup.points.size(),
                  fmt::format("{}: line {}", path.string(), face.line));
    rest = rest.subspan(face.corners);
  }
  if (others > 0) spdlog::warn("{}: {} points and lines are left out", oneLine(path.string()), others);
  return soup;
}

}  // namespace tetralux
