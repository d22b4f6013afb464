#include "scene/transfer_file.h"

#include "base/check.h"
#include "base/files.h"
#include "transfer_presets.h"

namespace tetralux {

std::vector<ControlPoint> controlPoints(JsonObject& object) {
  std::vector<ControlPoint> points;
  for (JsonObject& point : object.objects("points")) {
    points.push_back({point.number("s"), point.vec3("rgb"), point.number("tau")});
    point.finish();
  }
  return points;
}

TransferFunction parseTransferFunction(JsonObject object) {
  Emission emission = Emission::PerExtinction;
  if (object.has("emission") && object.oneOf("emission", {"per_extinction", "per_length"}) == 1)
    emission = Emission::PerLength;
  TransferFunction result(controlPoints(object), object.where("points"), emission);
  object.finish();
  return result;
}

TransferFunction readTransferFunction(const std::filesystem::path& path) {
  const nlohmann::json document = parseJson(readTextFile(path), path.string());
  JsonObject root(document, path.string(), "");
  return parseTransferFunction(root.has("transfer_function") ? root.object("transfer_function") : root);
}

std::vector<std::string> transferPresetNames() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : transfer_presets::files())
    names.push_back(std::filesystem::path(file.name).stem().string());
  return names;
}

std::optional<std::vector<ControlPoint>> transferPreset(std::string_view name) {
  const EmbeddedFile* file = findEmbedded(transfer_presets::files(), std::string(name) + ".json");
  if (!file) return std::nullopt;
  const nlohmann::json document = parseJson(file->text(), std::string(file->name));
  JsonObject root(document, std::string(file->name), "");
  std::vector<ControlPoint> points = controlPoints(root);
  root.finish();
  CHECK(points.size() >= 2);
  return points;
}

}  // namespace tetralux
