#include "cli/write_image.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cctype>

#include "base/error.h"

namespace tetralux::cli {
namespace {

std::string lowerExtension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

}  // namespace

void ExrFormatOptions::add(CLI::App& app) {
  app.add_option("--exr-type", type, "Numbers in EXR files: float or half (default: float)")
      ->check(CLI::IsMember({"float", "half"}));
  app.add_option("--exr-compression", compression,
                 "none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa or dwab (default: zip; the last five lose digits)");
}

ExrOptions ExrFormatOptions::exrOptions() const {
  ExrOptions options;
  options.half = type == "half";
  options.compression = parseExrCompression(compression);
  return options;
}

void checkImageName(const std::string& path, bool pngAllowed) {
  const std::string extension = lowerExtension(path);
  if (extension == ".exr" || (pngAllowed && extension == ".png")) return;
  fail(ErrorCode::Usage, "-o: found '{}', expected a name that ends in .exr{}", path, pngAllowed ? " or .png" : "");
}

void writeImage(const Image& image, const std::filesystem::path& path, const Scene& scene, const Camera& camera,
                ExrOptions exr) {
  if (lowerExtension(path) == ".png") {
    writePng(image, path, glm::vec3(scene.background));
  } else {
    exr.viewFromWorld = camera.viewFromWorld();
    exr.clipFromWorld = camera.clipFromWorld(scene.size);
    writeExr(image, path, exr);
  }
  spdlog::info("wrote {}", path.string());
}

}  // namespace tetralux::cli
