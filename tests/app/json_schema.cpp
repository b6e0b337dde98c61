#include "json_schema.h"

#include <fmt/core.h>

#include <algorithm>
#include <regex>
#include <set>

namespace crest::test {
namespace {

using nlohmann::json;

class Validator {
 public:
  explicit Validator(const json& root) : root_(root) {}

  void check(const json& value, const json& schema, const std::string& path) {
    for (const auto& [keyword, rule] : schema.items()) check_keyword(value, schema, keyword, rule, path);
  }

  std::vector<std::string> faults;

 private:
  void expect(bool holds, const std::string& path, const std::string& keyword, const json& rule) {
    if (!holds) faults.push_back(fmt::format("{}: {} {}", path, keyword, rule.dump()));
  }

  void check_keyword(const json& value, const json& schema, const std::string& keyword, const json& rule,
                     const std::string& path) {
    static const std::set<std::string> no_rules{"$schema", "$defs", "title", "description"};
    if (no_rules.contains(keyword)) return;
    if (keyword == "$ref")
      return check(value, root_.at(json::json_pointer(rule.get<std::string>().substr(1))), path);
    if (keyword == "type") return expect(is_of_type(value, rule), path, keyword, rule);
    if (keyword == "const") return expect(value == rule, path, keyword, rule);
    if (keyword == "enum") return expect(std::ranges::find(rule, value) != rule.end(), path, keyword, rule);
    if (keyword == "anyOf") return expect(fits_any(value, rule), path, keyword, "");
    if (keyword == "minimum") return expect(!value.is_number() || value >= rule, path, keyword, rule);
    if (keyword == "maximum") return expect(!value.is_number() || value <= rule, path, keyword, rule);
    if (keyword == "exclusiveMinimum") return expect(!value.is_number() || value > rule, path, keyword, rule);
    if (keyword == "exclusiveMaximum") return expect(!value.is_number() || value < rule, path, keyword, rule);
    if (keyword == "minItems") return expect(value.size() >= rule, path, keyword, rule);
    if (keyword == "maxItems") return expect(value.size() <= rule, path, keyword, rule);
    if (keyword == "pattern")
      return expect(!value.is_string() ||
                        std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())),
                    path, keyword, rule);
    if (keyword == "required") {
      for (const auto& key : rule) expect(value.is_object() && value.contains(key), path, keyword, key);
    } else if (keyword == "items") {
      for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
        check(value[i], rule, fmt::format("{}[{}]", path, i));
    } else if (keyword == "properties") {
      for (const auto& [key, property] : rule.items())
        if (value.is_object() && value.contains(key)) check(value[key], property, path + "." + key);
    } else if (keyword == "additionalProperties") {
      check_additional(value, schema.value("properties", json::object()), rule, path);
    } else {
      faults.push_back(fmt::format("{}: the keyword {} is not known here", path, keyword));
    }
  }

  void check_additional(const json& value, const json& known, const json& rule, const std::string& path) {
    if (!value.is_object()) return;
    for (const auto& [key, property] : value.items()) {
      if (known.contains(key)) continue;
      if (rule.is_boolean())
        expect(rule.get<bool>(), path + "." + key, "additionalProperties", rule);
      else
        check(property, rule, path + "." + key);
    }
  }

  bool fits_any(const json& value, const json& choices) const {
    return std::ranges::any_of(choices, [&](const json& choice) {
      Validator one(root_);
      one.check(value, choice, "");
      return one.faults.empty();
    });
  }

  static bool is_of_type(const json& value, const json& type) {
    if (type.is_array())
      return std::ranges::any_of(type, [&](const json& one) { return is_of_type(value, one); });
    const std::string name = type;
    return name == "object"    ? value.is_object()
           : name == "array"   ? value.is_array()
           : name == "string"  ? value.is_string()
           : name == "boolean" ? value.is_boolean()
           : name == "null"    ? value.is_null()
           : name == "integer" ? value.is_number_integer()
                               : name == "number" && value.is_number();
  }

  const json& root_;
};

}  // namespace

std::vector<std::string> schema_faults(const json& value, const json& schema) {
  Validator validator(schema);
  validator.check(value, schema, "$");
  return validator.faults;
}

}  // namespace crest::test
