// Strict reading of JSON: every key must be known, every value of the expected kind, every error says where.
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>

namespace tetralux {

// Parses text. Throws Error(Input): file, line and column of a syntax error, or a key that occurs twice.
//   place   the file's name, for messages
nlohmann::json parseJson(std::string_view text, const std::string& place);

// One object of a document. Ask for keys, then call finish(): a key that nobody asked for is an error.
// Every function throws Error(Input): "file: camera.eye[1]: found "x", expected a number".
class JsonObject {
 public:
  //   value   must outlive this object
  //   place   file name
  //   path    of this object in the document, "" for the root
  JsonObject(const nlohmann::json& value, std::string place, std::string path);

  bool has(const char* key);
  double number(const char* key);
  double number(const char* key, double otherwise);
  // A whole number from `low` to `high`.
  std::uint32_t integer(const char* key, std::uint32_t low, std::uint32_t high);
  bool flag(const char* key, bool otherwise);
  std::string text(const char* key);
  // One of `names`; returns its index.
  size_t oneOf(const char* key, std::initializer_list<const char*> names);
  glm::dvec3 vec3(const char* key);
  std::vector<double> numbers(const char* key);
  JsonObject object(const char* key);
  // Every element must be an object.
  std::vector<JsonObject> objects(const char* key);

  void finish() const;

  // "file: path.key", as messages begin.
  std::string where(const std::string& key = "") const;

 private:
  const nlohmann::json& require(const char* key, const char* expected);

  const nlohmann::json* value_;
  std::string place_;
  std::string path_;
  std::set<std::string> known_;
};

}  // namespace tetralux
