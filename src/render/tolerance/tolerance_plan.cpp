#include "render/tolerance/tolerance_plan.h"

#include <fmt/format.h>

#include <algorithm>

namespace tetralux::render {
namespace {

double partsBound(PartAccuracy accuracy, double luminance, double change) {
  const PartError error = partError(accuracy);
  return error.opacity * luminance + error.moment * change;
}

void planIntegration(TolerancePlan& plan, double luminance, const CellClasses& classes) {
  const double budget = kIntegrationShare * plan.tolerance;
  const std::string counts =
      fmt::format("the mean's colour is good enough for {} cells, {} more hold no control point, {} do",
                  classes.average, classes.linear, classes.pieces);
  if (classes.pieces == 0 && classes.linear == 0) {
    plan.integration = Integration::Average;
    plan.decisions.push_back({"integration", "average", counts, classes.worstMean});
    return;
  }
  for (const PartAccuracy accuracy : {PartAccuracy::Coarse, PartAccuracy::Medium, PartAccuracy::Fine}) {
    if (partsBound(accuracy, luminance, classes.worstChange) > budget) continue;
    plan.accuracy = accuracy;
    break;
  }
  plan.decisions.push_back({"integration", fmt::format("exact, {} parts", partAccuracyName(plan.accuracy)),
                            fmt::format("{}; luminance up to {:.3g} changes by up to {:.3g} along a part", counts,
                                        luminance, classes.worstChange),
                            partsBound(plan.accuracy, luminance, classes.worstChange)});
}

}  // namespace

TolerancePlan planTolerance(double tolerance, double largestLuminance, const CellClasses& classes) {
  const double luminance = std::max(largestLuminance, 1.0);  // alpha is a channel like the others
  TolerancePlan plan;
  plan.tolerance = tolerance;
  planIntegration(plan, luminance, classes);
  const double omitted = kOmissionShare * tolerance / luminance;
  plan.leastTransmittance = std::max(kLeastTransmittance, static_cast<float>(omitted));
  plan.decisions.push_back({"omission", fmt::format("light behind a transmittance of {:.2g}", plan.leastTransmittance),
                            fmt::format("luminance is at most {:.3g}", luminance),
                            static_cast<double>(plan.leastTransmittance) * luminance});
  return plan;
}

TolerancePlan planFully(double tolerance, const std::string& reason) {
  TolerancePlan plan;
  plan.tolerance = tolerance;
  plan.decisions.push_back({"integration", "exact, full parts", reason, 0.0});
  return plan;
}

double largestLuminance(const TransferFunction& transfer, double low, double high) {
  double largest = 0.0;
  const auto take = [&](const glm::dvec3& rgb) { largest = std::max({largest, rgb.x, rgb.y, rgb.z}); };
  for (const TransferPiece& piece : transfer.pieces()) {
    if (piece.high < low || piece.low > high) continue;
    take(piece.at(std::clamp(low, piece.low, piece.high)).luminance);
    take(piece.at(std::clamp(high, piece.low, piece.high)).luminance);
  }
  return largest;
}

}  // namespace tetralux::render
