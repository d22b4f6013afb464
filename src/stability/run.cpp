#include "stability/run.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "image/metrics.h"
#include "reference/ray_caster.h"
#include "reference/segment_integral.h"

namespace tetralux::stability {
namespace {

struct CaseError {
  double rmse = 0.0;
  double largest = 0.0;
  std::uint64_t nonFinite = 0;
};

void take(Outcome& outcome, const CaseError& error, const std::string& name) {
  if (error.largest >= outcome.largest) outcome.worstCase = name;
  outcome.rmse = std::max(outcome.rmse, error.rmse);
  outcome.largest = std::max(outcome.largest, error.largest);
  outcome.nonFinite += error.nonFinite;
}

// The renderer of the last method, kept while the next asks for the same.
class Pictures {
 public:
  Pictures(const gpu::Context& context, const PictureCase& picture)
      : context_(context), case_(picture), field_(scalarField(picture.mesh, "", picture.name)) {
    exact_ = reference::toImage(reference::renderPixels({case_.mesh, field_, case_.transfer, case_.camera, case_.size}),
                                case_.size);
  }

  CaseError errorOf(const Method& method) {
    if (!renderer_ || projection_ != method.renderer.projection || order_ != method.renderer.order) {
      renderer_ = std::make_unique<render::Renderer>(context_, case_.mesh, field_, method.renderer);
      renderer_->setTransferFunction(case_.transfer);
      projection_ = method.renderer.projection;
      order_ = method.renderer.order;
    }
    renderer_->draw(case_.camera, case_.size, method.frame);
    const ImageDifference difference = compareImages(exact_, renderer_->readImage());
    return {difference.rmse, difference.max, difference.nonFinite};
  }

 private:
  const gpu::Context& context_;
  const PictureCase& case_;
  ScalarField field_;
  Image exact_;
  std::unique_ptr<render::Renderer> renderer_;
  render::CellProjection projection_ = render::CellProjection::Pt;
  render::Order order_ = render::Order::Auto;
};

CaseError segmentError(const gpu::Context& context, const SegmentCase& c, const Method& method) {
  render::CellLengths lengths{0.0f, 0.0f};
  for (const Segment& s : c.segments) {
    lengths.longest = std::max(lengths.longest, static_cast<float>(s.length));
    lengths.mean += static_cast<float>(s.length) / static_cast<float>(c.segments.size());
  }
  const auto found =
      integrateOnDevice(context, c.transfer, c.segments, method.frame.integration, method.frame.table, lengths);
  CaseError error;
  double squares = 0.0;
  for (size_t i = 0; i < c.segments.size(); i++) {
    const Segment s = roundedSegment(c.segments[i]);
    const SegmentOptics exact = reference::integrateSegment(c.transfer, s.front, s.back, s.length);
    const glm::dvec4 expected(exact.light, exact.alpha);
    for (int channel = 0; channel < 4; channel++) {
      double difference = std::abs(expected[channel] - static_cast<double>(found[i][channel]));
      if (!std::isfinite(difference)) {
        error.nonFinite++;
        difference = 1.0;
      }
      error.largest = std::max(error.largest, difference);
      squares += difference * difference;
    }
  }
  error.rmse = std::sqrt(squares / (4.0 * static_cast<double>(c.segments.size())));
  return error;
}

bool drawsSegments(const Method& method) { return method.axis == "default" || method.axis == "integration"; }

}  // namespace

std::vector<Outcome> runRegion(const gpu::Context& context, const Region& region, std::span<const Method> methods) {
  const RegionCases cases = region.cases();
  std::vector<Outcome> outcomes;
  for (const Method& method : methods) {
    Outcome outcome{region.name, method.fullName()};
    outcome.applies = !cases.pictures.empty() || drawsSegments(method);
    outcomes.push_back(std::move(outcome));
  }
  const auto forEach = [&](const std::string& name, const auto& errorOf) {
    for (size_t i = 0; i < methods.size(); i++) {
      if (!outcomes[i].applies) continue;
      try {
        take(outcomes[i], errorOf(methods[i]), name);
      } catch (const Error& e) {
        if (e.code() != ErrorCode::Usage) throw;
        outcomes[i].applies = false;
      }
    }
  };
  for (const PictureCase& c : cases.pictures) {
    Pictures pictures(context, c);
    forEach(c.name, [&](const Method& method) { return pictures.errorOf(method); });
  }
  for (const SegmentCase& c : cases.segments)
    forEach(c.name, [&](const Method& method) { return segmentError(context, c, method); });
  return outcomes;
}

}  // namespace tetralux::stability
