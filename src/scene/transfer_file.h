// Transfer functions from files and presets.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/json_object.h"
#include "volume/transfer_function.h"

namespace tetralux {

// The "points" of a JSON object: [{"s", "rgb", "tau"}, ...]. Other keys of the object are left to the caller.
std::vector<ControlPoint> controlPoints(JsonObject& object);

// A whole transfer function: "points" and, optionally, "emission", which is "per_extinction" (the default) or
// "per_length". Throws Error(Input), also on any other key.
TransferFunction parseTransferFunction(JsonObject object);

// A file {"points": [...]}, with "emission" where wanted, or a scene file, whose "transfer_function" is taken; s in the
// field's units, tau per world unit. Throws Error(Input).
TransferFunction readTransferFunction(const std::filesystem::path& path);

// Names of the colour maps that come with the program.
std::vector<std::string> transferPresetNames();

// Control points of a preset: s from 0 to 1 over the field's range, tau as weights against each other (see
// volume/equalize.h). Nothing when there is no preset of that name. A preset has no emission per length: its
// extinctions are fitted to the field, and light that does not follow them would be of any brightness.
std::optional<std::vector<ControlPoint>> transferPreset(std::string_view name);

}  // namespace tetralux
