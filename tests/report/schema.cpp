// SPDX-License-Identifier: MIT
#include "tests/report/schema.h"

#include <regex>
#include <set>
#include <stdexcept>

namespace evenmesh::testing {
namespace {

using nlohmann::json;

bool has_type(const json& value, const std::string& type) {
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "null") return value.is_null();
  throw std::invalid_argument("no type of JSON Schema: " + type);
}

bool has_one_type(const json& value, const json& types) {
  if (types.is_string()) return has_type(value, types);
  for (const json& type : types) {
    if (has_type(value, type)) return true;
  }
  return false;
}

class Validator {
 public:
  explicit Validator(const json& root) : root_(root) {}

  void check(const json& schema, const json& value, const std::string& at) {
    if (schema.is_boolean()) {
      if (!schema.get<bool>()) report(at, "is not allowed");
      return;
    }
    refuse_unknown_words(schema);
    if (schema.contains("$ref")) check(referred(schema["$ref"]), value, at);
    check_value(schema, value, at);
    if (value.is_object()) check_object(schema, value, at);
    if (value.is_array() && schema.contains("items")) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        check(schema["items"], value[i], at + "/" + std::to_string(i));
      }
    }
  }

  std::vector<std::string> violations;

 private:
  void report(const std::string& at, const std::string& what) {
    violations.push_back(at + ": " + what);
  }

  static void refuse_unknown_words(const json& schema) {
    static const std::set<std::string> kKnown{
        "type",       "enum",       "minimum", "pattern",
        "required",   "properties", "$ref",    "additionalProperties",
        "items",      "$defs",      "$schema", "title",
        "description"};
    for (const auto& [word, unused] : schema.items()) {
      if (!kKnown.contains(word)) throw std::invalid_argument("unknown word: " + word);
    }
  }

  const json& referred(const std::string& reference) const {
    if (!reference.starts_with("#")) throw std::invalid_argument("a far $ref: " + reference);
    return root_.at(json::json_pointer(reference.substr(1)));
  }

  void check_value(const json& schema, const json& value, const std::string& at) {
    if (schema.contains("type") && !has_one_type(value, schema["type"])) {
      report(at, value.dump() + " is not of type " + schema["type"].dump());
    }
    if (schema.contains("enum")) {
      const json& known = schema["enum"];
      if (std::find(known.begin(), known.end(), value) == known.end()) {
        report(at, value.dump() + " is not one of " + known.dump());
      }
    }
    if (schema.contains("minimum") && value.is_number() && value < schema["minimum"]) {
      report(at, value.dump() + " is less than " + schema["minimum"].dump());
    }
    if (schema.contains("pattern") && value.is_string() &&
        !std::regex_search(value.get<std::string>(),
                           std::regex(schema["pattern"].get<std::string>()))) {
      report(at, value.dump() + " does not match " + schema["pattern"].dump());
    }
  }

  void check_object(const json& schema, const json& value, const std::string& at) {
    for (const json& key : schema.value("required", json::array())) {
      if (!value.contains(key)) report(at, "'" + key.get<std::string>() + "' is missing");
    }
    const json properties = schema.value("properties", json::object());
    for (const auto& [key, member] : value.items()) {
      if (properties.contains(key)) {
        check(properties[key], member, at + "/" + key);
      } else if (schema.contains("additionalProperties")) {
        check(schema["additionalProperties"], member, at + "/" + key);
      }
    }
  }

  const json& root_;
};

}  // namespace

std::vector<std::string> schema_violations(const json& schema, const json& document) {
  Validator validator(schema);
  validator.check(schema, document, "");
  return validator.violations;
}

}  // namespace evenmesh::testing
