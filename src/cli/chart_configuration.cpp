#include "cli/chart_configuration.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "shared/limits.h"
#include "shared/pixel_lists.h"

namespace tetralux::cli {
namespace {

constexpr const char* kPlace = "--configuration";

std::uint32_t parseCount(const std::string& key, const std::string& text, std::uint32_t low, std::uint32_t high) {
  std::uint32_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || value < low || value > high)
    fail(ErrorCode::Usage, "{}: {}: found '{}', expected a number from {} to {}", kPlace, key, text, low, high);
  return value;
}

struct Key {
  const char* name;
  bool ofRenderer;         // chosen when the renderer is made
  const char* namePrefix;  // of the value in Configuration::name()
  void (*set)(DeviceOptions& options, const std::string& value);
};

// What can be chosen. Values are checked where DeviceOptions turns them into enumerations.
const Key kKeys[] = {
    {"integration", false, "", [](DeviceOptions& o, const std::string& v) { o.integration = v; }},
    {"table-size", false, "", [](DeviceOptions& o, const std::string& v) { o.tableSize = v; }},
    {"table-format", false, "", [](DeviceOptions& o, const std::string& v) { o.tableFormat = v; }},
    {"table-build", false, "", [](DeviceOptions& o, const std::string& v) { o.tableBuild = v; }},
    {"interpolation", false, "", [](DeviceOptions& o, const std::string& v) { o.interpolation = v; }},
    {"projection", true, "", [](DeviceOptions& o, const std::string& v) { o.projection = v; }},
    {"order", true, "order ", [](DeviceOptions& o, const std::string& v) { o.order = v; }},
    {"k", true,
     "k=", [](DeviceOptions& o, const std::string& v) { o.kBuffer = parseCount("k", v, 0, shared::KBUFFER_LARGEST); }},
    {"tolerance", true, "tolerance ", [](DeviceOptions& o, const std::string& v) { o.tolerance = v; }},
    {"target", false, "", [](DeviceOptions& o, const std::string& v) { o.target = v; }},
    {"chunk-cells", false, "chunks of ",
     [](DeviceOptions& o, const std::string& v) {
       o.chunkCells = parseCount("chunk-cells", v, 1, shared::BATCH_CELLS);
     }},
};

// Those of the command line, but for the projection: what is compared is drawn by fans, which know every choice.
const std::vector<std::string>& defaults() {
  static const std::vector<std::string> values = [] {
    const DeviceOptions o;
    return std::vector<std::string>{o.integration,
                                    o.tableSize,
                                    o.tableFormat,
                                    o.tableBuild,
                                    o.interpolation,
                                    "pt",
                                    o.order,
                                    fmt::format("{}", o.kBuffer),
                                    o.tolerance,
                                    o.target,
                                    ""};
  }();
  return values;
}

size_t indexOf(const std::string& key) {
  const auto& keys = Configuration::keys();
  const auto found = std::find(keys.begin(), keys.end(), key);
  if (found == keys.end())
    fail(ErrorCode::Usage, "{}: found key '{}', expected one of {}", kPlace, key, fmt::join(keys, ", "));
  return static_cast<size_t>(found - keys.begin());
}

}  // namespace

Configuration::Configuration() : values_(defaults()) {}

const std::vector<std::string>& Configuration::keys() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Key& key : kKeys) list.emplace_back(key.name);
    return list;
  }();
  return names;
}

Configuration Configuration::parse(const std::string& text) {
  Configuration configuration;
  size_t at = 0;
  while (at <= text.size()) {
    const size_t end = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, end - at);
    const size_t equals = part.find('=');
    if (equals == std::string::npos)
      fail(ErrorCode::Usage, "{}: found '{}', expected KEY=VALUE with a key of {}", kPlace, part,
           fmt::join(keys(), ", "));
    configuration = configuration.with(part.substr(0, equals), part.substr(equals + 1));
    at = end + 1;
  }
  return configuration;
}

Configuration Configuration::with(const std::string& key, const std::string& value) const {
  Configuration changed = *this;
  changed.values_[indexOf(key)] = value;
  try {
    const DeviceOptions options = changed.deviceOptions();
    options.rendererOptions();
    options.renderOptions();
  } catch (const Error& e) {
    const std::string message = e.what();
    if (message.starts_with(kPlace)) throw;
    fail(ErrorCode::Usage, "{}: {}", kPlace, message);
  }
  return changed;
}

std::string Configuration::name() const {
  std::string name;
  for (size_t i = 0; i < values_.size(); i++) {
    if (values_[i] == defaults()[i]) continue;
    const std::string prefix = values_[i] == "auto" ? std::string(kKeys[i].name) + " " : kKeys[i].namePrefix;
    name += (name.empty() ? "" : " ") + prefix + values_[i];
  }
  return name.empty() ? "default" : name;
}

std::string Configuration::text() const {
  std::string text;
  for (size_t i = 0; i < values_.size(); i++)
    text += fmt::format("{}{}={}", i == 0 ? "" : ",", kKeys[i].name, values_[i]);
  return text;
}

std::string Configuration::rendererText() const {
  std::string text;
  for (size_t i = 0; i < values_.size(); i++) {
    if (kKeys[i].ofRenderer) text += fmt::format("{}={},", kKeys[i].name, values_[i]);
  }
  return text;
}

const std::string& Configuration::value(const std::string& key) const { return values_[indexOf(key)]; }

DeviceOptions Configuration::deviceOptions() const {
  DeviceOptions options;
  for (size_t i = 0; i < values_.size(); i++) {
    if (!values_[i].empty()) kKeys[i].set(options, values_[i]);
  }
  return options;
}

}  // namespace tetralux::cli
