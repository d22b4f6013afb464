#include "cli/appearance_options.h"

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "image/color.h"
#include "scene/appearance_file.h"

namespace tetralux::cli {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

// All of a text as a finite number.
std::optional<double> finiteNumber(std::string_view text) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// Linear rgb of six hexadecimal digits.
std::optional<glm::dvec3> linearColor(std::string_view text) {
  std::uint32_t digits = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), digits, 16);
  if (text.size() != 6 || error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  const auto channel = [&](int shift) { return linearFromSrgb(((digits >> shift) & 255u) / 255.0); };
  return glm::dvec3(channel(16), channel(8), channel(0));
}

}  // namespace

void AppearanceOptions::add(CLI::App& app) {
  app.add_option("--iso", isosurfaces,
                 "Isosurface, VALUE[:RGB[:OPACITY]]: RGB as six hexadecimal digits (default: e0e0e0), OPACITY from 0 "
                 "to 1 (default: 1); may be repeated; instead of the scene's")
      ->type_name("ISO");
  app.add_option("--clip", clip, "Clip plane, NX,NY,NZ,OFFSET: keeps points p with n.p >= OFFSET; may be repeated")
      ->type_name("PLANE");
  app.add_flag("--no-volume", noVolume, "Show isosurfaces and surfaces only");
}

void AppearanceOptions::apply(Appearance& appearance) const {
  if (noVolume) appearance.volumeVisible = false;
  if (!isosurfaces.empty()) appearance.isosurfaces.clear();
  for (const std::string& text : isosurfaces) appearance.isosurfaces.push_back(parseIsosurface(text));
  sortIsosurfaces(appearance.isosurfaces, "--iso");
  for (const std::string& text : clip) appearance.clip.push_back(parseClipPlane(text));
}

Isosurface parseIsosurface(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, ':');
  const std::optional<double> value = finiteNumber(parts[0]);
  const std::optional<glm::dvec3> rgb = linearColor(parts.size() > 1 ? parts[1] : "e0e0e0");
  const std::optional<double> opacity = finiteNumber(parts.size() > 2 ? parts[2] : "1");
  if (parts.size() > 3 || !value || !rgb || !opacity || !(*opacity >= 0.0 && *opacity <= 1.0))
    fail(ErrorCode::Usage,
         "--iso: found '{}', expected VALUE, VALUE:RGB or VALUE:RGB:OPACITY, such as 0.5:ff8020:0.7 (RGB: six "
         "hexadecimal digits; OPACITY: 0 to 1)",
         text);
  Isosurface surface;
  surface.value = *value;
  surface.rgb = surface.backRgb = *rgb;
  surface.opacity = *opacity;
  return surface;
}

ClipPlane parseClipPlane(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, ',');
  std::vector<double> numbers;
  for (const std::string_view part : parts) {
    if (const std::optional<double> number = finiteNumber(part)) numbers.push_back(*number);
  }
  if (parts.size() != 4 || numbers.size() != 4 || !(glm::length(glm::dvec3(numbers[0], numbers[1], numbers[2])) > 0.0))
    fail(ErrorCode::Usage, "--clip: found '{}', expected NX,NY,NZ,OFFSET with a normal that is not zero", text);
  return {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

}  // namespace tetralux::cli
