#include <cmath>

#include "base/error.h"
#include "mesh/triangle_mesh.h"
#include "mesh/triangle_soup.h"
#include "mesh/vtk_text.h"

namespace tetralux {
namespace {

void checkPoints(const std::vector<glm::dvec3>& points, const std::string& place) {
  for (size_t i = 0; i < points.size(); i++) {
    for (int axis = 0; axis < 3; axis++) {
      if (!std::isfinite(points[i][axis]))
        fail(ErrorCode::Input, "{}: point {}: coordinate {} is {}, expected a finite number", place, i, "xyz"[axis],
             points[i][axis]);
    }
  }
}

}  // namespace

TriangleMesh readTriangleMesh(const std::filesystem::path& path) {
  struct Reader {
    const char* extension;
    TriangleSoup (*read)(const std::filesystem::path& path);
  };
  const Reader readers[] = {{".stl", readStl}, {".ply", readPly}, {".obj", readObj}, {".vtp", readVtp}};
  const std::string extension = path.extension().string();
  for (const Reader& reader : readers) {
    if (lowerCase(extension) != reader.extension) continue;
    const TriangleSoup soup = reader.read(path);
    checkPoints(soup.points, path.string());
    TriangleMesh mesh = welded(soup);
    if (mesh.triangles.empty())
      fail(ErrorCode::Input, "{}: no triangle whose corners differ, expected at least one", path.string());
    return mesh;
  }
  fail(ErrorCode::Input, "{}: file name ends in '{}', expected .stl, .ply, .obj or .vtp", path.string(), extension);
}

}  // namespace tetralux
