#include "reference/ray_painter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "base/check.h"
#include "reference/cell_ray.h"
#include "reference/classified_integral.h"
#include "reference/isosurface_crossings.h"
#include "reference/piece_count.h"
#include "reference/pixel_tiles.h"
#include "reference/ray_interval.h"
#include "reference/segment_integral.h"
#include "reference/segment_links.h"

namespace tetralux::reference {
namespace {

// Scalars of one place, found in two cells, differ by less than this share of the field's range.
constexpr double kScalarTolerance = 1e-9;

// Share of its depth below which the length of a segment is rounding.
constexpr double kThinnestSegment = 1e-12;

struct RayChord {
  CellChord chord;
  std::uint32_t cell = 0;

  double middle() const { return 0.5 * (chord.segment.front + chord.segment.back); }
};

void sortByMiddle(std::vector<RayChord>& chords) {
  std::sort(chords.begin(), chords.end(), [](const RayChord& a, const RayChord& b) {
    return std::tuple(a.middle(), a.cell) < std::tuple(b.middle(), b.cell);
  });
}

// Whether a ray meets a cell only by rounding, as where it passes an edge of several. The order of such segments is
// rounding, too: what little the scalar changes in them must not be taken for a crossing.
bool isRounding(const CellSegment& segment, double scalarTolerance) {
  return segment.back - segment.front <= kThinnestSegment * segment.back &&
         std::abs(segment.sBack - segment.sFront) <= scalarTolerance;
}

// Whole chords in the order of the ray, the scalar where one goes on from another the same on both sides.
std::vector<RayChord> chordsOf(const ReferenceScene& scene, const Ray& ray, std::span<const std::uint32_t> cells) {
  const double scalarTolerance = kScalarTolerance * (scene.field.high - scene.field.low);
  std::vector<RayChord> chords;
  for (const std::uint32_t cell : cells) {
    const CellGeometry geometry(cellVertices(scene.mesh, cell), cellScalars(scene.mesh, scene.field, cell));
    RayChord chord{{}, cell};
    if (geometry.empty() || !geometry.intersect(ray, chord.chord)) continue;
    if (!isRounding(chord.chord.segment, scalarTolerance)) chords.push_back(chord);
  }
  sortByMiddle(chords);
  if (scene.field.association == FieldAssociation::Cell) return chords;  // its scalar jumps between cells
  std::vector<CellSegment> segments;
  for (const RayChord& chord : chords) segments.push_back(chord.chord.segment);
  const auto before = predecessors(segments, scalarTolerance);
  for (size_t i = 0; i < chords.size(); i++) {
    if (before[i] != kNoSegment) chords[i].chord.segment.sFront = segments[before[i]].sBack;
  }
  return chords;
}

// Light and opacity of a ray so far, from the front.
class RayLight {
 public:
  explicit RayLight(ReferencePixel& pixel) : pixel_(pixel) {}

  void add(const SegmentOptics& optics) {
    pixel_.light += transmittance_ * optics.light;
    pixel_.alpha += (1.0 - pixel_.alpha) * optics.alpha;
    transmittance_ *= 1.0 - optics.alpha;
  }

  void addSurface(const glm::dvec3& rgb, double opacity) {
    pixel_.light += transmittance_ * opacity * rgb;
    pixel_.alpha = opacity < 1.0 ? pixel_.alpha + (1.0 - pixel_.alpha) * opacity : 1.0;
    transmittance_ *= 1.0 - opacity;
  }

 private:
  ReferencePixel& pixel_;
  double transmittance_ = 1.0;
};

// The visible part of a ray in a cell.
class Segment {
 public:
  Segment(const ReferenceScene& scene, const Ray& ray, const RayChord& chord)
      : scene_(scene), appearance_(*scene.appearance), ray_(ray), chord_(chord.chord), cell_(chord.cell) {
    if (appearance_.volumeVisible && isClassified(appearance_)) classify();
  }

  // Composites everything in the cell. False when nothing behind it is seen.
  bool composite(RayLight& light, ReferencePixel& pixel) const {
    const CellSegment& segment = chord_.segment;
    double uFrom = 0.0;
    double sFrom = segment.sFront;
    for (const Crossing& crossing : isosurfaceCrossings(appearance_.isosurfaces, segment.sFront, segment.sBack)) {
      const Isosurface& surface = *crossing.surface;
      addVolume(uFrom, crossing.share, sFrom, surface.value, light, pixel);
      light.addSurface(colour(crossing), surface.opacity);
      pixel.crossings++;
      if (surface.opacity == 1.0) return false;
      uFrom = crossing.share;
      sFrom = surface.value;
    }
    addVolume(uFrom, 1.0, sFrom, segment.sBack, light, pixel);
    return true;
  }

 private:
  double length() const { return (chord_.segment.back - chord_.segment.front) * ray_.lengthPerDepth; }

  glm::dvec3 toEye() const { return -ray_.direction / ray_.lengthPerDepth; }

  void addVolume(double uFrom, double uTo, double sFrom, double sTo, RayLight& light, ReferencePixel& pixel) const {
    if (!appearance_.volumeVisible || !(uFrom < uTo)) return;
    if (isClassified(appearance_)) {
      const ClassifiedOptics classified = integrateClassified(scene_.transfer, appearance_, classified_, uFrom, uTo);
      light.add(classified.optics);
      pixel.pieces += classified.pieces;
    } else {
      light.add(integrateSegment(scene_.transfer, sFrom, sTo, (uTo - uFrom) * length()));
      pixel.pieces += pieceCount(scene_.transfer, sFrom, sTo);
    }
  }

  // What the volume's optics depend on, at both ends of the visible part.
  void classify() {
    const AppearanceData& data = *scene_.data;
    classified_.scalar = {chord_.segment.sFront, chord_.segment.sBack};
    classified_.length = length();
    for (size_t i = 0; i < appearance_.modulations.size(); i++) {
      if (appearance_.modulations[i].by == ModulatedBy::ViewCosine)
        classified_.modulators.push_back({viewCosine(0.0), viewCosine(1.0)});
      else
        classified_.modulators.push_back(ends(data.modulators[i]));
    }
    if (appearance_.rgbaField) {
      classified_.rgbaFront = glm::max(interpolated(data.rgba, 0.0), glm::dvec4(0.0));
      classified_.rgbaBack = glm::max(interpolated(data.rgba, 1.0), glm::dvec4(0.0));
    } else if (appearance_.transfer2d) {
      classified_.gradientMagnitude = ends(data.gradientMagnitudes);
    }
    if (appearance_.volumeShading != Shading::None) {
      classified_.lightFront = illuminate(appearance_.lighting, interpolated(data.gradients, 0.0), toEye());
      classified_.lightBack = illuminate(appearance_.lighting, interpolated(data.gradients, 1.0), toEye());
    }
  }

  // Where all four vertices have one value, which a step of a curve may lie at, exactly that one.
  EndValues ends(const std::vector<double>& values) const {
    const CellVertices& v = scene_.mesh.cells[cell_];
    const auto [low, high] = std::minmax({values[v[0]], values[v[1]], values[v[2]], values[v[3]]});
    return {std::clamp(interpolated(values, 0.0), low, high), std::clamp(interpolated(values, 1.0), low, high)};
  }

  double viewCosine(double u) const {
    const glm::dvec3 gradient = interpolated(scene_.data->gradients, u);
    const double steepness = glm::length(gradient);
    return steepness > 0.0 ? std::min(1.0, std::abs(glm::dot(gradient, toEye())) / steepness) : 1.0;
  }

  glm::dvec3 colour(const Crossing& crossing) const {
    const Isosurface& surface = *crossing.surface;
    const glm::dvec3& rgb = crossing.isRising ? surface.rgb : surface.backRgb;
    if (surface.shading == Shading::None) return rgb;
    const glm::dvec3 normal =
        surface.shading == Shading::Flat ? cellGradient() : interpolated(scene_.data->gradients, crossing.share);
    return illuminate(appearance_.lighting, normal, toEye()).lit(rgb);
  }

  glm::dvec3 cellGradient() const {
    return CellGeometry(cellVertices(scene_.mesh, cell_), cellScalars(scene_.mesh, scene_.field, cell_)).gradient();
  }

  // Of values at the mesh's vertices, at a share of the visible part.
  template <typename Value>
  Value interpolated(const std::vector<Value>& values, double u) const {
    const CellVertices& vertices = scene_.mesh.cells[cell_];
    Value sum(0.0);
    for (size_t i = 0; i < 4; i++)
      sum += std::lerp(chord_.weightsFront[i], chord_.weightsBack[i], u) * values[vertices[i]];
    return sum;
  }

  const ReferenceScene& scene_;
  const Appearance& appearance_;
  const Ray& ray_;
  const CellChord& chord_;
  std::uint32_t cell_;
  ClassifiedSegment classified_;
};

bool interpolatesGradients(const Appearance& appearance) {
  const auto isPhong = [](const Isosurface& surface) { return surface.shading == Shading::Phong; };
  const auto isByView = [](const Modulation& modulation) { return modulation.by == ModulatedBy::ViewCosine; };
  return std::any_of(appearance.isosurfaces.begin(), appearance.isosurfaces.end(), isPhong) ||
         (appearance.volumeVisible &&
          (appearance.volumeShading != Shading::None ||
           std::any_of(appearance.modulations.begin(), appearance.modulations.end(), isByView)));
}

void checkData(const ReferenceScene& scene) {
  CHECK(scene.appearance && scene.data);
  const Appearance& appearance = *scene.appearance;
  const AppearanceData& data = *scene.data;
  const size_t points = scene.mesh.pointCount();
  CHECK(appearance.isosurfaces.empty() || scene.field.association == FieldAssociation::Point);
  if (interpolatesGradients(appearance)) CHECK_EQ(data.gradients.size(), points);
  if (!appearance.volumeVisible) return;
  CHECK_EQ(data.modulators.size(), appearance.modulations.size());
  for (size_t i = 0; i < data.modulators.size(); i++) {
    if (appearance.modulations[i].by != ModulatedBy::ViewCosine) CHECK_EQ(data.modulators[i].size(), points);
  }
  if (appearance.rgbaField) CHECK_EQ(data.rgba.size(), points);
  if (appearance.transfer2d) CHECK_EQ(data.gradientMagnitudes.size(), points);
}

}  // namespace

RayPainter::RayPainter(const ReferenceScene& scene) : scene_(scene) { checkData(scene); }

ReferencePixel RayPainter::paint(const Ray& ray, std::span<const std::uint32_t> cells, const SurfaceHit& hit) const {
  ReferencePixel pixel;
  DepthRange range = keptRange(scene_.appearance->clip, ray);
  range.high = std::min(range.high, hit.depth);
  std::vector<RayChord> chords = chordsOf(scene_, ray, cells);
  std::erase_if(chords, [&](RayChord& chord) { return !cutChord(chord.chord, range); });
  sortByMiddle(chords);
  RayLight light(pixel);
  for (const RayChord& chord : chords) {
    pixel.layers++;
    if (!Segment(scene_, ray, chord).composite(light, pixel)) return pixel;
  }
  if (hit.surface) light.addSurface(surfaceColour(hit, ray, scene_.appearance->lighting), 1.0);
  return pixel;
}

}  // namespace tetralux::reference
