// One way of drawing, as `chart` compares them: options of `render` by name.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "cli/common_options.h"

namespace tetralux::cli {

class Configuration {
 public:
  // The program's defaults.
  Configuration();

  // "KEY=VALUE,KEY=VALUE..." with names of options without their dashes; what is left out has its default. Throws
  // Error(Usage) that names an unknown key or value and what is expected.
  static Configuration parse(const std::string& text);

  // The same with one value changed. Throws Error(Usage).
  Configuration with(const std::string& key, const std::string& value) const;

  // What differs from the defaults, for people: "ppi 128x128", "march", "default".
  std::string name() const;

  // Every value, in a fixed order: "integration=exact,projection=pt,...". Equal texts draw equal pictures.
  std::string text() const;

  const std::string& value(const std::string& key) const;

  // Names of the keys, in the order of text().
  static const std::vector<std::string>& keys();

  // The options that it stands for.
  DeviceOptions deviceOptions() const;

  // What a renderer is made with: the part of text() that is not chosen per frame.
  std::string rendererText() const;

  bool operator==(const Configuration&) const = default;

 private:
  std::vector<std::string> values_;  // one per key
};

}  // namespace tetralux::cli
