#include "scene/json_object.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace tetralux {
namespace {

using nlohmann::json;

std::string shown(const json& value) {
  std::string text = value.dump();
  constexpr size_t kLongest = 60;
  return text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
}

double finiteNumber(const json& value, const std::string& where) {
  if (!value.is_number()) fail(ErrorCode::Input, "{}: found {}, expected a number", where, shown(value));
  return value.get<double>();
}

// Line and column of a byte, both from 1.
std::pair<size_t, size_t> lineAndColumn(std::string_view text, size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const size_t lines = static_cast<size_t>(std::count(before.begin(), before.end(), '\n'));
  const size_t lastBreak = before.rfind('\n');
  return {lines + 1, before.size() - (lastBreak == std::string_view::npos ? 0 : lastBreak + 1) + 1};
}

}  // namespace

json parseJson(std::string_view text, const std::string& place) {
  std::vector<std::set<std::string>> keys;
  const auto rejectRepeatedKeys = [&](int, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
      fail(ErrorCode::Input, "{}: key {} occurs twice in one object", place, shown(parsed));
    return true;
  };
  try {
    return json::parse(text, rejectRepeatedKeys);
  } catch (const json::parse_error& e) {
    const auto [line, column] = lineAndColumn(text, e.byte == 0 ? 0 : e.byte - 1);
    fail(ErrorCode::Input, "{}: line {}, column {}: not valid JSON", place, line, column);
  } catch (const json::exception&) {
    fail(ErrorCode::Input, "{}: holds a number beyond the range of double precision", place);
  }
}

JsonObject::JsonObject(const json& value, std::string place, std::string path)
    : value_(&value), place_(std::move(place)), path_(std::move(path)) {
  if (!value.is_object()) fail(ErrorCode::Input, "{}: found {}, expected an object {{...}}", where(), shown(value));
}

std::string JsonObject::where(const std::string& key) const {
  const std::string separator = path_.empty() || key.empty() ? "" : ".";
  const std::string full = path_ + separator + key;
  return full.empty() ? place_ : fmt::format("{}: {}", place_, full);
}

const json& JsonObject::require(const char* key, const char* expected) {
  known_.insert(key);
  const auto found = value_->find(key);
  if (found == value_->end()) fail(ErrorCode::Input, "{}: missing, expected {}", where(key), expected);
  return *found;
}

bool JsonObject::has(const char* key) {
  known_.insert(key);
  return value_->contains(key);
}

double JsonObject::number(const char* key) { return finiteNumber(require(key, "a number"), where(key)); }

double JsonObject::number(const char* key, double otherwise) { return has(key) ? number(key) : otherwise; }

std::uint32_t JsonObject::integer(const char* key, std::uint32_t low, std::uint32_t high) {
  const json& value = require(key, "a whole number");
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= low && number <= high) || number != std::floor(number))
    fail(ErrorCode::Input, "{}: found {}, expected a whole number from {} to {}", where(key), shown(value), low, high);
  return static_cast<std::uint32_t>(number);
}

bool JsonObject::flag(const char* key, bool otherwise) {
  if (!has(key)) return otherwise;
  const json& value = require(key, "true or false");
  if (!value.is_boolean()) fail(ErrorCode::Input, "{}: found {}, expected true or false", where(key), shown(value));
  return value.get<bool>();
}

std::string JsonObject::text(const char* key) {
  const json& value = require(key, "a text");
  if (!value.is_string()) fail(ErrorCode::Input, "{}: found {}, expected a text", where(key), shown(value));
  return value.get<std::string>();
}

size_t JsonObject::oneOf(const char* key, std::initializer_list<const char*> names) {
  const std::string expected = fmt::format("one of \"{}\"", fmt::join(names, "\", \""));
  const json& value = require(key, expected.c_str());
  const auto found = std::find_if(names.begin(), names.end(), [&](const char* name) { return value == name; });
  if (found == names.end()) fail(ErrorCode::Input, "{}: found {}, expected {}", where(key), shown(value), expected);
  return static_cast<size_t>(found - names.begin());
}

glm::dvec3 JsonObject::vec3(const char* key) {
  const json& value = require(key, "three numbers [x, y, z]");
  if (!value.is_array() || value.size() != 3)
    fail(ErrorCode::Input, "{}: found {}, expected three numbers [x, y, z]", where(key), shown(value));
  glm::dvec3 result;
  for (int i = 0; i < 3; i++)
    result[i] = finiteNumber(value[static_cast<size_t>(i)], fmt::format("{}[{}]", where(key), i));
  return result;
}

std::vector<double> JsonObject::numbers(const char* key) {
  const json& value = require(key, "a list of numbers");
  if (!value.is_array()) fail(ErrorCode::Input, "{}: found {}, expected a list of numbers", where(key), shown(value));
  std::vector<double> result;
  for (size_t i = 0; i < value.size(); i++)
    result.push_back(finiteNumber(value[i], fmt::format("{}[{}]", where(key), i)));
  return result;
}

JsonObject JsonObject::object(const char* key) {
  const json& value = require(key, "an object {...}");
  return JsonObject(value, place_, path_.empty() ? key : path_ + "." + key);
}

std::vector<JsonObject> JsonObject::objects(const char* key) {
  const json& value = require(key, "a list of objects");
  if (!value.is_array()) fail(ErrorCode::Input, "{}: found {}, expected a list of objects", where(key), shown(value));
  std::vector<JsonObject> result;
  const std::string prefix = path_.empty() ? key : path_ + "." + key;
  for (size_t i = 0; i < value.size(); i++) result.emplace_back(value[i], place_, fmt::format("{}[{}]", prefix, i));
  return result;
}

void JsonObject::finish() const {
  for (const auto& item : value_->items()) {
    if (!known_.contains(item.key()))
      fail(ErrorCode::Input, "{}: unknown key, expected one of {}", where(item.key()), fmt::join(known_, ", "));
  }
}

}  // namespace tetralux
