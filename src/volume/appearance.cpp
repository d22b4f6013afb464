#include "volume/appearance.h"

#include <algorithm>

namespace tetralux {

bool Appearance::isPlain() const {
  return volumeVisible && volumeShading == Shading::None && isosurfaces.empty() && clip.empty() && surfaces.empty() &&
         modulations.empty() && !rgbaField && !transfer2d;
}

bool Appearance::needsGradients() const {
  const bool isSurfaceLit = std::any_of(isosurfaces.begin(), isosurfaces.end(),
                                        [](const Isosurface& i) { return i.shading == Shading::Phong; });
  const bool isModulated = std::any_of(modulations.begin(), modulations.end(),
                                       [](const Modulation& m) { return m.by != ModulatedBy::Field; });
  return isSurfaceLit || (volumeVisible && (volumeShading == Shading::Phong || isModulated || transfer2d.has_value()));
}

}  // namespace tetralux
