#include "fields/appearance_data.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "base/error.h"
#include "fields/boundary_distance.h"
#include "fields/gradients.h"
#include "mesh/triangle_mesh.h"

namespace tetralux {
namespace {

// The first thing that a field of one number per cell cannot give; null where there is none. Names are the scene's.
const char* needOfPoints(const Appearance& appearance) {
  if (!appearance.isosurfaces.empty()) return "isosurfaces";
  if (!appearance.volumeVisible) return nullptr;
  if (appearance.volumeShading == Shading::Phong) return "shading of the volume";
  for (const Modulation& modulation : appearance.modulations) {
    if (modulation.by == ModulatedBy::GradientMagnitude) return "opacity_by_gradient";
    if (modulation.by == ModulatedBy::BoundaryDistance) return "boundary_emphasis";
    if (modulation.by == ModulatedBy::ViewCosine) return "silhouette_emphasis";
  }
  return appearance.transfer2d ? "transfer_function_2d" : nullptr;
}

void checkAssociation(const ScalarField& field, const char* need, std::string_view place) {
  if (need && field.association == FieldAssociation::Cell)
    fail(ErrorCode::Input, "{}: field '{}' has one number per cell, expected one per point for {}", place, field.name,
         need);
}

// The field of that name, one number per point. Where there is none, the message lists the arrays that there are.
ScalarField pointField(const TetMesh& mesh, const std::string& name, const char* need, std::string_view place) {
  if (name.empty()) fail(ErrorCode::Input, "{}: found no name of an array, expected one for {}", place, need);
  ScalarField field = scalarField(mesh, name, place);
  checkAssociation(field, need, place);
  return field;
}

// A point array of that many components, for rgba_field.
const DataArray& pointArray(const TetMesh& mesh, const std::string& name, std::uint32_t components,
                            std::string_view place) {
  pointField(mesh, name, "rgba_field", place);  // complains of what is missing or not finite
  const DataArray& array = *std::find_if(mesh.pointArrays.begin(), mesh.pointArrays.end(),
                                         [&](const DataArray& a) { return a.name == name; });
  if (array.components != components)
    fail(ErrorCode::Input, "{}: array '{}' has {} components, expected {} for rgba_field", place, name,
         array.components, components);
  return array;
}

// Negative luminance and extinction count as 0.
std::vector<glm::dvec4> rgbaAtVertices(const TetMesh& mesh, const RgbaField& names, std::string_view place) {
  const DataArray& rgb = pointArray(mesh, names.rgb, 3, place);
  const DataArray& extinction = pointArray(mesh, names.extinction, 1, place);
  std::vector<glm::dvec4> rgba;
  rgba.reserve(mesh.pointCount());
  for (size_t i = 0; i < mesh.pointCount(); i++) {
    const glm::dvec4 numbers(rgb.value(i, 0), rgb.value(i, 1), rgb.value(i, 2), extinction.value(i));
    rgba.push_back(glm::max(numbers, 0.0));
  }
  return rgba;
}

void addGradients(const Appearance& appearance, const TetMesh& mesh, const ScalarField& field, AppearanceData& data) {
  const GradientFit fit(mesh);
  data.gradients = fit.gradients(field.values);
  if (!appearance.volumeVisible) return;
  for (size_t i = 0; i < appearance.modulations.size(); i++) {
    const Modulation& modulation = appearance.modulations[i];
    if (modulation.by == ModulatedBy::GradientMagnitude)
      data.modulators[i] = gradientMagnitudes(data.gradients);
    else if (modulation.by == ModulatedBy::BoundaryDistance)
      data.modulators[i] = boundaryDistances(fit, data.gradients, modulation.sigma, mesh.bounds().diagonal()).distances;
  }
  if (appearance.transfer2d) data.gradientMagnitudes = gradientMagnitudes(data.gradients);
}

// Each triangle counts at its corners by its area: cross products of edges are twice that long.
std::vector<glm::dvec3> normalsAtPoints(const TriangleMesh& mesh) {
  std::vector<glm::dvec3> normals(mesh.points.size(), glm::dvec3(0.0));
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 normal = glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    for (const std::uint32_t corner : {a, b, c}) normals[corner] += normal;
  }
  return normals;
}

OpaqueSurface readSurface(const SurfaceFile& file) {
  TriangleMesh mesh = readTriangleMesh(file.path);
  OpaqueSurface surface;
  if (file.shading == Shading::Phong) surface.normals = normalsAtPoints(mesh);
  surface.points = std::move(mesh.points);
  surface.triangles = std::move(mesh.triangles);
  surface.rgb = file.rgb;
  surface.backRgb = file.backRgb;
  surface.shading = file.shading;
  return surface;
}

}  // namespace

AppearanceData makeAppearanceData(const Appearance& appearance, const TetMesh& mesh, const ScalarField& field,
                                  std::string_view place) {
  checkAssociation(field, needOfPoints(appearance), place);
  AppearanceData data;
  data.modulators.resize(appearance.modulations.size());
  if (appearance.volumeVisible) {
    for (size_t i = 0; i < appearance.modulations.size(); i++) {
      const Modulation& modulation = appearance.modulations[i];
      if (modulation.by == ModulatedBy::Field)
        data.modulators[i] = pointField(mesh, modulation.field, "second_field", place).values;
    }
    if (appearance.rgbaField) data.rgba = rgbaAtVertices(mesh, *appearance.rgbaField, place);
  }
  if (appearance.needsGradients()) addGradients(appearance, mesh, field, data);
  for (const SurfaceFile& surface : appearance.surfaces) data.surfaces.push_back(readSurface(surface));
  return data;
}

}  // namespace tetralux
