#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/files.h"
#include "chart/false_color.h"
#include "cli/commands.h"
#include "cli/write_image.h"
#include "image/image_io.h"
#include "image/metrics.h"

namespace tetralux::cli {
namespace {

class CompareCommand : public Command {
 public:
  explicit CompareCommand(CLI::App& app) {
    app.add_option("reference", reference_, "Picture that is taken as right (.exr, .png)")
        ->required()
        ->type_name("REF");
    app.add_option("image", image_, "Picture to judge")->required()->type_name("IMAGE");
    app.add_flag("--json", json_, "Print JSON");
    app.add_option("--fail-above", failAbove_, "Exit status 1 when the RMSE is above this")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--fail-max-above", failMaxAbove_, "Exit status 1 when the largest difference is above this")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--difference", difference_,
                   "Write a picture of the differences, .png or .exr: the largest of each pixel's four channels in "
                   "false colours")
        ->type_name("FILE");
    app.add_option("--difference-scale", scale_, "Write the scale of those colours")->type_name("FILE.svg");
  }

  int run() override {
    if (!difference_.empty()) checkImageName(difference_, /*pngAllowed=*/true);
    const Image reference = tetralux::readImage(reference_);
    const Image image = tetralux::readImage(image_);
    const ImageDifference d = compareImages(reference, image);
    if (!difference_.empty()) writeDifference(chart::differencePicture(reference, image));
    if (!scale_.empty()) writeFile(scale_, chart::differenceLegendSvg());
    json_ ? printJson(d) : printText(d);
    const bool missed = (failAbove_ && d.rmse > *failAbove_) || (failMaxAbove_ && d.max > *failMaxAbove_);
    return missed ? 1 : 0;
  }

 private:
  void writeDifference(const Image& colors) const {
    if (std::filesystem::path(difference_).extension() == ".exr")
      writeExr(colors, difference_);
    else
      writePng(colors, difference_, glm::vec3(0.0f));
  }

  static void printJson(const ImageDifference& d) {
    nlohmann::ordered_json json;
    json["rmse"] = d.rmse;
    json["max"] = d.max;
    json["p99"] = d.p99;
    json["mean"] = d.mean;
    json["over_half_level"] = d.shareOverHalfLevel;
    json["psnr"] = std::isfinite(d.psnr) ? nlohmann::ordered_json(d.psnr) : nlohmann::ordered_json(nullptr);
    json["flip"] = d.flip;
    json["non_finite"] = d.nonFinite;
    json["worst"] = {d.worstX, d.worstY};
    fmt::print("{}\n", json.dump(1));
  }

  static void printText(const ImageDifference& d) {
    fmt::print("rmse              {:.4e}\n", d.rmse);
    fmt::print("max               {:.4e}  at pixel ({}, {})\n", d.max, d.worstX, d.worstY);
    fmt::print("p99               {:.4e}\n", d.p99);
    fmt::print("mean              {:.4e}\n", d.mean);
    fmt::print("over 0.5/255      {:.4f} % of pixels\n", d.shareOverHalfLevel * 100);
    fmt::print("psnr              {:.2f} dB\n", d.psnr);
    fmt::print("flip              {:.6f}\n", d.flip);
    if (d.nonFinite > 0) fmt::print("non-finite        {} values\n", d.nonFinite);
  }

  std::string reference_;
  std::string image_;
  bool json_ = false;
  std::string difference_;
  std::string scale_;
  std::optional<double> failAbove_;
  std::optional<double> failMaxAbove_;
};

}  // namespace

std::unique_ptr<Command> makeCompareCommand(CLI::App& app) { return std::make_unique<CompareCommand>(app); }

}  // namespace tetralux::cli
