#include "cli/certify_options.h"

#include <fmt/format.h>

#include <cmath>

#include "base/error.h"

namespace tetralux::cli {

void CertifyOptions::add(CLI::App& app) {
  app.add_option("--certify", count,
                 "Recompute N random pixels of those that show anything in double precision, and report the frame's "
                 "error; exit status 1 when it is over the tolerance")
      ->type_name("N")
      ->check(CLI::Range(1u, 100000000u));
  app.add_option("--certify-tolerance", ownTolerance,
                 "Largest error per pixel and channel (default: that of --tolerance, or 1/510)")
      ->type_name("E")
      ->check([](const std::string& text) {
        double value = 0.0;
        const bool isNumber = CLI::detail::lexical_cast(text, value);
        return isNumber && std::isfinite(value) && value >= 0.0 ? std::string()
                                                                : "found '" + text + "', expected a finite number >= 0";
      });
}

std::vector<std::pair<std::string, std::string>> Certifier::certify(const reference::ReferenceScene& scene,
                                                                    const Image& picture) {
  if (options_.count == 0) return {};
  const std::uint32_t seed = frames_ + 1;
  const reference::Certificate c = reference::certifyPicture(scene, picture, options_.count, seed, options_.tolerance);
  if (!worst_ || c.check.max > worst_->check.max ||
      (c.check.max == worst_->check.max && c.check.rmse > worst_->check.rmse)) {
    worst_ = c;
    worstFrame_ = frames_;
  }
  missed_ += c.holds() ? 0 : 1;
  frames_++;
  const auto number = [](auto value) { return fmt::format("{}", value); };
  return {{"tetralux.certify.pixels", number(c.check.pixels)},
          {"tetralux.certify.covered_pixels", number(c.coveredPixels)},
          {"tetralux.certify.seed", number(seed)},
          {"tetralux.certify.tolerance", number(c.tolerance)},
          {"tetralux.certify.max", number(c.check.max)},
          {"tetralux.certify.p99", number(c.check.p99)},
          {"tetralux.certify.rmse", number(c.check.rmse)},
          {"tetralux.certify.over", number(c.check.over)},
          {"tetralux.certify.share_over_bound", number(c.shareOverBound)}};
}

nlohmann::ordered_json Certifier::json() const {
  if (!worst_) return nullptr;
  const reference::PictureCheck& check = worst_->check;
  return {{"frames", frames_},
          {"frames_over", missed_},
          {"worst_frame", worstFrame_},
          {"pixels", check.pixels},
          {"covered_pixels", worst_->coveredPixels},
          {"tolerance", worst_->tolerance},
          {"max", check.max},
          {"p99", check.p99},
          {"rmse", check.rmse},
          {"over", check.over},
          {"share_over_bound", worst_->shareOverBound},
          {"ms", worst_->ms}};
}

void Certifier::report(const std::string& place) const {
  if (!worst_) return;
  const reference::PictureCheck& check = worst_->check;
  const std::string frame = frames_ > 1 ? fmt::format("worst of {} frames, {}: ", frames_, worstFrame_) : "";
  fmt::print(
      "certify: {}{} of {} covered pixels: largest {:.3g}, p99 {:.3g}, RMSE {:.3g}; {} over {:.3g}, with 99 % "
      "confidence at most {:.3g} % of all\n",
      frame, check.pixels, worst_->coveredPixels, check.max, check.p99, check.rmse, check.over, worst_->tolerance,
      100.0 * worst_->shareOverBound);
  std::fflush(stdout);
  if (missed_ > 0)
    fail(ErrorCode::Limit, "{}: {}largest error {:.3g}, expected at most {:.3g}", place, frame, check.max,
         worst_->tolerance);
}

}  // namespace tetralux::cli
