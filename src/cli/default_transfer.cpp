#include "cli/default_transfer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/transfer_file.h"
#include "volume/equalize.h"

namespace tetralux::cli {
namespace {

// Optical depth of an average ray across the mesh: dense enough to see colours, thin enough to see inside.
constexpr double kOpticalDepth = 2.5;

// Cells whose values stand for the field; more would not change the picture.
constexpr size_t kSampleCount = 200000;

std::vector<WeightedScalar> sampleField(const TetMesh& mesh, const ScalarField& field) {
  std::vector<WeightedScalar> samples;
  const size_t step = std::max<size_t>(1, mesh.cellCount() / kSampleCount);
  for (size_t cell = 0; cell < mesh.cellCount(); cell += step) {
    const CellVertices& v = mesh.cells[cell];
    const glm::dvec3 a = mesh.point(v[0]);
    const double volume6 =
        std::abs(glm::dot(mesh.point(v[1]) - a, glm::cross(mesh.point(v[2]) - a, mesh.point(v[3]) - a)));
    if (field.association == FieldAssociation::Cell) {
      samples.push_back({field.values[cell], volume6});
    } else {
      // The vertices rather than their mean: a mean hides the extremes.
      for (const std::uint32_t vertex : v) samples.push_back({field.values[vertex], 0.25 * volume6});
    }
  }
  return samples;
}

bool hasBothSigns(const ScalarField& field) {
  constexpr double kSmallestShare = 0.2;  // of the larger side
  return field.low < 0.0 && field.high > 0.0 &&
         std::min(-field.low, field.high) >= kSmallestShare * std::max(-field.low, field.high);
}

}  // namespace

TransferFunction defaultTransfer(const TetMesh& mesh, const ScalarField& field, const std::string& preset) {
  const std::string name = !preset.empty() ? preset : hasBothSigns(field) ? "diverging" : "flow";
  std::vector<ControlPoint> points = transferPreset(name).value();
  double low = field.low;
  double high = field.high;
  if (name == "diverging" && hasBothSigns(field)) {
    high = std::max(-low, high);
    low = -high;
  }
  // A constant field still needs control points in order.
  if (!(high > low)) high = std::nextafter(low, std::numeric_limits<double>::infinity());
  for (ControlPoint& p : points) p.s = low * (1.0 - p.s) + high * p.s;
  const double diagonal = mesh.bounds().diagonal();
  return equalizedOpacity(points, sampleField(mesh, field), diagonal > 0.0 ? diagonal : 1.0, kOpticalDepth);
}

}  // namespace tetralux::cli
