// The keys of a scene file beside mesh, camera, image and transfer function.
#pragma once

#include <filesystem>

#include "scene/json_object.h"
#include "volume/appearance.h"

namespace tetralux {

// Reads "isosurfaces", "lighting", "volume", "clip", "surfaces", "opacity_by_gradient", "boundary_emphasis",
// "silhouette_emphasis", "second_field", "rgba_field" and "transfer_function_2d" of a scene, all optional. Throws
// Error(Input).
//   folder   that relative paths of surfaces start at
Appearance parseAppearance(JsonObject& scene, const std::filesystem::path& folder);

// Puts isosurfaces in ascending order. Throws Error(Input) beginning with `place` where two have one value.
void sortIsosurfaces(std::vector<Isosurface>& isosurfaces, std::string_view place);

}  // namespace tetralux
