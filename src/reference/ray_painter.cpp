#include "reference/ray_painter.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/check.h"
#include "reference/cell_ray.h"
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
      : scene_(scene), ray_(ray), chord_(chord) {}

  // Composites everything in the cell. False when nothing behind it is seen.
  bool composite(RayLight& light, ReferencePixel& pixel) const {
    const Appearance& appearance = *scene_.appearance;
    const CellSegment& segment = chord_.chord.segment;
    double uFrom = 0.0;
    double sFrom = segment.sFront;
    for (const Crossing& crossing : isosurfaceCrossings(appearance.isosurfaces, segment.sFront, segment.sBack)) {
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
  void addVolume(double uFrom, double uTo, double sFrom, double sTo, RayLight& light, ReferencePixel& pixel) const {
    if (!(uFrom < uTo)) return;
    const CellSegment& segment = chord_.chord.segment;
    const double length = (uTo - uFrom) * (segment.back - segment.front) * ray_.lengthPerDepth;
    light.add(integrateSegment(scene_.transfer, sFrom, sTo, length));
    pixel.pieces += pieceCount(scene_.transfer, sFrom, sTo);
  }

  glm::dvec3 colour(const Crossing& crossing) const {
    const Isosurface& surface = *crossing.surface;
    const glm::dvec3& rgb = crossing.isRising ? surface.rgb : surface.backRgb;
    if (surface.shading == Shading::None) return rgb;
    const glm::dvec3 normal = surface.shading == Shading::Flat ? cellGradient() : gradientAt(crossing.share);
    return illuminate(scene_.appearance->lighting, normal, -ray_.direction / ray_.lengthPerDepth).lit(rgb);
  }

  glm::dvec3 cellGradient() const {
    return CellGeometry(cellVertices(scene_.mesh, chord_.cell), cellScalars(scene_.mesh, scene_.field, chord_.cell))
        .gradient();
  }

  // Of the gradients at the vertices.
  glm::dvec3 gradientAt(double u) const {
    const CellVertices& vertices = scene_.mesh.cells[chord_.cell];
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < 4; i++) {
      const double weight = (1.0 - u) * chord_.chord.weightsFront[i] + u * chord_.chord.weightsBack[i];
      sum += weight * scene_.data->gradients[vertices[i]];
    }
    return sum;
  }

  const ReferenceScene& scene_;
  const Ray& ray_;
  const RayChord& chord_;
};

}  // namespace

RayPainter::RayPainter(const ReferenceScene& scene) : scene_(scene) {
  CHECK(scene.appearance && scene.data);
  CHECK(scene.appearance->isosurfaces.empty() || scene.field.association == FieldAssociation::Point);
  if (scene.appearance->needsGradients()) CHECK_EQ(scene.data->gradients.size(), scene.mesh.pointCount());
}

ReferencePixel RayPainter::paint(const Ray& ray, std::span<const std::uint32_t> cells) const {
  ReferencePixel pixel;
  const DepthRange range = keptRange(scene_.appearance->clip, ray);
  std::vector<RayChord> chords = chordsOf(scene_, ray, cells);
  std::erase_if(chords, [&](RayChord& chord) { return !cutChord(chord.chord, range); });
  sortByMiddle(chords);
  RayLight light(pixel);
  for (const RayChord& chord : chords) {
    pixel.layers++;
    if (!Segment(scene_, ray, chord).composite(light, pixel)) break;
  }
  return pixel;
}

}  // namespace tetralux::reference
