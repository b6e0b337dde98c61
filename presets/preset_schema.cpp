#include "presets/preset_schema.h"

#include "presets/fields.h"
#include "presets/json.h"
#include "presets/names.h"
#include "presets/preset_json.h"

namespace crest {
namespace {

Json schema_of(double, const FieldRule& rule) {
  Json schema = {{"type", "number"}};
  if (rule.min > any_value.min) schema[rule.open_min ? "exclusiveMinimum" : "minimum"] = rule.min;
  if (rule.max < any_value.max) schema[rule.open_max ? "exclusiveMaximum" : "maximum"] = rule.max;
  return schema;
}

Json schema_of(int, const FieldRule& rule) {
  return {{"type", "integer"}, {"minimum", int(rule.min)}, {"maximum", int(rule.max)}};
}

Json schema_of(bool, const FieldRule&) { return {{"type", "boolean"}}; }

Json schema_of(const std::string&, const FieldRule&) { return {{"type", "string"}}; }

Json schema_of(const glm::dvec3&, const FieldRule& rule) {
  return {{"type", "array"}, {"items", schema_of(0.0, rule)}, {"minItems", 3}, {"maxItems", 3}};
}

template <NamedEnum T>
Json schema_of(T, const FieldRule&) {
  Json names = Json::array();
  for (const Named<T>& named : names_of<T>()) names.push_back(named.name);
  return {{"enum", std::move(names)}};
}

template <Fielded T>
Json schema_of(const T& values, const FieldRule&);

template <class T>
Json schema_of(const std::optional<T>&, const FieldRule& rule) {
  return {{"anyOf", Json::array({schema_of(T{}, rule), {{"type", "null"}}})}};
}

template <class T>
Json schema_of(const std::vector<T>&, const FieldRule& rule) {
  return {{"type", "array"}, {"items", schema_of(T{}, rule)}};
}

/// Keys that are not listed are allowed, and kept.
template <Fielded T>
Json schema_of(const T& values, const FieldRule&) {
  Json properties = Json::object(), needed = Json::array();
  visit_fields(values, [&](const char* name, const auto& field, const FieldRule& rule) {
    properties[name] = schema_of(field, rule);
    if (rule.required) needed.push_back(name);
  });
  Json schema = {{"type", "object"}, {"properties", std::move(properties)}};
  if (!needed.empty()) schema["required"] = std::move(needed);
  return schema;
}

}  // namespace

std::string preset_schema() {
  Json schema = {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "Crest preset"},
      {"description", "A transfer function with how it is rendered. Keys that are not listed are kept."}};
  Json preset = schema_of(Preset{}, any_value);
  Json properties = {{"format", {{"const", preset_format}}}, {"version", {{"const", preset_version}}}};
  properties.update(preset["properties"]);
  preset["properties"] = std::move(properties);
  schema.update(preset);
  return schema.dump(1) + "\n";
}

}  // namespace crest
