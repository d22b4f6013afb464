// What is shown of a field beside, or instead of, a volume with one transfer function: isosurfaces, lighting,
// classification by more than one number, clip planes, opaque surfaces. Defaults change nothing. docs/appearance.md
// says what each means.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "volume/factor_curve.h"
#include "volume/lighting.h"
#include "volume/transfer_function_2d.h"

namespace tetralux {

// The boundary of {s >= value}. A ray that comes to a cell's exit with s0 at its entry crosses it there when exactly
// one of s0, s1 is
// >= value: so a surface through a shared face, edge or vertex is counted once.
struct Isosurface {
  double value = 0.0;
  glm::dvec3 rgb{1.0};      // where s rises along the ray, linear, >= 0
  glm::dvec3 backRgb{1.0};  // where s falls
  double opacity = 1.0;     // 0 to 1
  Shading shading = Shading::Phong;
};

// Keeps the points p with dot(normal, p) >= offset, world.
struct ClipPlane {
  glm::dvec3 normal{0.0, 0.0, 1.0};  // any length > 0
  double offset = 0.0;
};

// A surface in a file of its own (mesh/triangle_mesh.h), opaque.
struct SurfaceFile {
  std::filesystem::path path;
  glm::dvec3 rgb{0.8};      // where its triangles are seen anticlockwise
  glm::dvec3 backRgb{0.8};  // where clockwise
  Shading shading = Shading::Flat;
};

// What a factor of extinction and luminance depends on. All are linear along a ray's segment in a cell.
enum class ModulatedBy {
  GradientMagnitude,  // of the field, at vertices: field units per world unit
  BoundaryDistance,   // Kindlmann and Durkin (1998), at vertices, world units
  Field,              // another point array
  ViewCosine,         // |cosine| between gradient and ray, where the ray enters and leaves the cell
};

struct Modulation {
  ModulatedBy by = ModulatedBy::GradientMagnitude;
  std::string field;            // of ModulatedBy::Field
  std::optional<double> sigma;  // of ModulatedBy::BoundaryDistance: width of boundaries, world units; none: estimated
  FactorCurve curve;
};

// Colour and extinction from arrays instead of the transfer function: linear inside cells.
struct RgbaField {
  std::string rgb;         // point array of three components: luminance
  std::string extinction;  // point array of one component, 1/world unit
};

struct Appearance {
  bool volumeVisible = true;
  Shading volumeShading = Shading::None;  // None or Phong
  std::vector<Isosurface> isosurfaces;    // ascending, no two of the same value
  Lighting lighting;
  std::vector<ClipPlane> clip;
  std::vector<SurfaceFile> surfaces;
  std::vector<Modulation> modulations;  // all of them apply
  std::optional<RgbaField> rgbaField;
  std::optional<TransferFunction2d> transfer2d;

  // Whether the transfer function's control points say nothing: another classification does, or the volume is not
  // shown.
  bool replacesTransferFunction() const { return !volumeVisible || rgbaField || transfer2d; }

  // Whether it is the volume alone.
  bool isPlain() const;

  // Whether gradients at vertices are needed.
  bool needsGradients() const;
};

// A triangle mesh that is shown.
struct OpaqueSurface {
  std::vector<glm::dvec3> points;  // world
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<glm::dvec3> normals;  // per point, any length; empty unless shading is Phong
  glm::dvec3 rgb{0.8};
  glm::dvec3 backRgb{0.8};
  Shading shading = Shading::Flat;
};

// What an appearance needs of a mesh (fields/appearance_data.h makes it). Vectors are empty where nothing needs them.
struct AppearanceData {
  std::vector<glm::dvec3> gradients;            // per vertex, field units per world unit
  std::vector<std::vector<double>> modulators;  // per modulation, per vertex; empty for ModulatedBy::ViewCosine
  std::vector<double> gradientMagnitudes;       // per vertex, for a transfer function of two dimensions
  std::vector<glm::dvec4> rgba;                 // per vertex: luminance, extinction
  std::vector<OpaqueSurface> surfaces;
};

}  // namespace tetralux
