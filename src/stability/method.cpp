#include "stability/method.h"

namespace tetralux::stability {
namespace {

using render::CellProjection;
using render::Integration;
using render::Interpolation;
using render::Order;
using render::Target;

std::vector<Method> makeMethods() {
  std::vector<Method> list{{"default", "default", {}, {}, true}};
  list.front().renderer.projection = CellProjection::Auto;
  const auto add = [&](const char* axis, const std::string& name, const auto& change) {
    Method method{axis, name, {}, {}, false};
    change(method);
    list.push_back(std::move(method));
  };
  for (const std::string& name : render::integrationNames()) {
    if (name != "exact")
      add("integration", name, [&](Method& m) { m.frame.integration = render::parseIntegration(name); });
  }
  add("interpolation", "screen", [](Method& m) { m.frame.interpolation = Interpolation::Screen; });
  for (const std::string& name : render::targetNames()) {
    if (name != "rgba32f") add("target", name, [&](Method& m) { m.frame.target = render::parseTarget(name); });
  }
  for (const std::string& name : render::orderNames()) {
    if (name != "auto") add("order", name, [&](Method& m) { m.renderer.order = render::parseOrder(name); });
  }
  for (const std::string& name : render::projectionNames()) {
    if (name == "auto") continue;  // the default
    add("projection", name, [&](Method& m) {
      m.renderer.projection = render::parseProjection(name);
      m.isStrict = true;
    });
  }
  return list;
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> list = makeMethods();
  return list;
}

}  // namespace tetralux::stability
