#include "scene/appearance_file.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/error.h"

namespace tetralux {
namespace {

double nonNegative(JsonObject& object, const char* key, double otherwise) {
  const double value = object.number(key, otherwise);
  if (!(value >= 0.0)) fail(ErrorCode::Input, "{}: found {}, expected a number >= 0", object.where(key), value);
  return value;
}

glm::dvec3 color(JsonObject& object, const char* key) {
  const glm::dvec3 rgb = object.vec3(key);
  for (int i = 0; i < 3; i++) {
    if (!(rgb[i] >= 0.0))
      fail(ErrorCode::Input, "{}[{}]: found {}, expected a number >= 0", object.where(key), i, rgb[i]);
  }
  return rgb;
}

// A direction or normal: not zero.
glm::dvec3 direction(JsonObject& object, const char* key) {
  const glm::dvec3 vector = object.vec3(key);
  const double length = glm::length(vector);
  if (!(length > 0.0 && length < 1e150))
    fail(ErrorCode::Input, "{}: found a vector of length {}, expected a finite length > 0", object.where(key), length);
  return vector;
}

Shading shading(JsonObject& object, Shading otherwise) {
  if (!object.has("shading")) return otherwise;
  return static_cast<Shading>(object.oneOf("shading", {"none", "flat", "phong"}));
}

std::vector<Isosurface> parseIsosurfaces(JsonObject& scene) {
  std::vector<Isosurface> isosurfaces;
  for (JsonObject& object : scene.objects("isosurfaces")) {
    Isosurface surface;
    surface.value = object.number("value");
    surface.rgb = color(object, "rgb");
    surface.backRgb = object.has("back_rgb") ? color(object, "back_rgb") : surface.rgb;
    surface.opacity = object.number("opacity", 1.0);
    if (!(surface.opacity >= 0.0 && surface.opacity <= 1.0))
      fail(ErrorCode::Input, "{}: found {}, expected a number from 0 to 1", object.where("opacity"), surface.opacity);
    surface.shading = shading(object, Shading::Phong);
    object.finish();
    isosurfaces.push_back(surface);
  }
  sortIsosurfaces(isosurfaces, scene.where("isosurfaces"));
  return isosurfaces;
}

Lighting parseLighting(JsonObject object) {
  Lighting lighting;
  lighting.ambient = nonNegative(object, "ambient", lighting.ambient);
  lighting.diffuse = nonNegative(object, "diffuse", lighting.diffuse);
  lighting.specular = nonNegative(object, "specular", lighting.specular);
  lighting.shininess = object.number("shininess", lighting.shininess);
  if (!(lighting.shininess >= 1.0))
    fail(ErrorCode::Input, "{}: found {}, expected a number >= 1", object.where("shininess"), lighting.shininess);
  lighting.headLight = object.flag("head_light", lighting.headLight);
  if (object.has("lights")) {
    for (JsonObject& light : object.objects("lights")) {
      DirectionalLight parsed;
      parsed.direction = glm::normalize(direction(light, "direction"));
      if (light.has("rgb")) parsed.rgb = color(light, "rgb");
      light.finish();
      lighting.lights.push_back(parsed);
    }
  }
  object.finish();
  return lighting;
}

void parseVolume(JsonObject object, Appearance& appearance) {
  appearance.volumeVisible = object.flag("visible", true);
  if (object.has("shading") && object.oneOf("shading", {"none", "phong"}) == 1)
    appearance.volumeShading = Shading::Phong;
  object.finish();
}

std::vector<ClipPlane> parseClip(JsonObject& scene) {
  std::vector<ClipPlane> planes;
  for (JsonObject& object : scene.objects("clip")) {
    planes.push_back({direction(object, "normal"), object.number("offset")});
    object.finish();
  }
  return planes;
}

std::vector<SurfaceFile> parseSurfaces(JsonObject& scene, const std::filesystem::path& folder) {
  std::vector<SurfaceFile> surfaces;
  for (JsonObject& object : scene.objects("surfaces")) {
    SurfaceFile surface;
    surface.path = folder / object.text("mesh");
    if (object.has("rgb")) surface.rgb = color(object, "rgb");
    surface.backRgb = object.has("back_rgb") ? color(object, "back_rgb") : surface.rgb;
    surface.shading = shading(object, Shading::Flat);
    object.finish();
    surfaces.push_back(surface);
  }
  return surfaces;
}

// {"points": [{VALUE, "factor", "rgb"?}, ...]}
FactorCurve parseCurve(JsonObject& object, const char* value) {
  std::vector<FactorPoint> points;
  for (JsonObject& point : object.objects("points")) {
    FactorPoint parsed;
    parsed.value = point.number(value);
    parsed.factor = point.number("factor", 1.0);
    if (point.has("rgb")) parsed.rgb = point.vec3("rgb");
    point.finish();
    points.push_back(parsed);
  }
  return FactorCurve(std::move(points), object.where("points"));
}

void parseModulations(JsonObject& scene, std::vector<Modulation>& modulations) {
  const auto add = [&](const char* key, ModulatedBy by, const char* value) {
    if (!scene.has(key)) return;
    JsonObject object = scene.object(key);
    Modulation modulation;
    modulation.by = by;
    if (by == ModulatedBy::Field) modulation.field = object.text("field");
    if (by == ModulatedBy::BoundaryDistance && object.has("sigma")) {
      modulation.sigma = object.number("sigma");
      if (!(*modulation.sigma > 0.0))
        fail(ErrorCode::Input, "{}: found {}, expected a number > 0", object.where("sigma"), *modulation.sigma);
    }
    modulation.curve = parseCurve(object, value);
    object.finish();
    modulations.push_back(modulation);
  };
  add("opacity_by_gradient", ModulatedBy::GradientMagnitude, "gradient");
  add("boundary_emphasis", ModulatedBy::BoundaryDistance, "distance");
  add("silhouette_emphasis", ModulatedBy::ViewCosine, "cosine");
  add("second_field", ModulatedBy::Field, "s");
}

TransferFunction2d parseTransfer2d(JsonObject object) {
  std::vector<double> scalars = object.numbers("scalars");
  std::vector<double> gradients = object.numbers("gradients");
  std::vector<OpticalSample> samples;
  for (JsonObject& sample : object.objects("samples")) {
    samples.push_back({sample.vec3("rgb"), sample.number("tau")});
    sample.finish();
  }
  TransferFunction2d result(std::move(scalars), std::move(gradients), std::move(samples), object.where());
  object.finish();
  return result;
}

}  // namespace

void sortIsosurfaces(std::vector<Isosurface>& isosurfaces, std::string_view place) {
  std::stable_sort(isosurfaces.begin(), isosurfaces.end(),
                   [](const Isosurface& a, const Isosurface& b) { return a.value < b.value; });
  const auto twice = std::adjacent_find(isosurfaces.begin(), isosurfaces.end(),
                                        [](const Isosurface& a, const Isosurface& b) { return a.value == b.value; });
  if (twice != isosurfaces.end())
    fail(ErrorCode::Input, "{}: found the value {} twice, expected different values", place, twice->value);
}

Appearance parseAppearance(JsonObject& scene, const std::filesystem::path& folder) {
  Appearance appearance;
  if (scene.has("isosurfaces")) appearance.isosurfaces = parseIsosurfaces(scene);
  if (scene.has("lighting")) appearance.lighting = parseLighting(scene.object("lighting"));
  if (scene.has("volume")) parseVolume(scene.object("volume"), appearance);
  if (scene.has("clip")) appearance.clip = parseClip(scene);
  if (scene.has("surfaces")) appearance.surfaces = parseSurfaces(scene, folder);
  parseModulations(scene, appearance.modulations);
  if (scene.has("rgba_field")) {
    JsonObject object = scene.object("rgba_field");
    appearance.rgbaField = RgbaField{object.text("rgb"), object.text("extinction")};
    object.finish();
  }
  if (scene.has("transfer_function_2d")) appearance.transfer2d = parseTransfer2d(scene.object("transfer_function_2d"));
  if (appearance.rgbaField && appearance.transfer2d)
    fail(ErrorCode::Input, "{}: found it beside rgba_field, expected one of the two",
         scene.where("transfer_function_2d"));
  return appearance;
}

}  // namespace tetralux
