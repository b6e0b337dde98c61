#include <cmath>

#include "presets/fields.h"
#include "presets/json.h"
#include "presets/names.h"
#include "presets/preset_json.h"

namespace crest {
namespace {

/// Whole numbers are written as such: 1, not 1.0.
Json to_json(double value, Fields) {
  const bool whole =
      value == std::trunc(value) && std::abs(value) < 1e15 && !(value == 0 && std::signbit(value));
  return whole ? Json(std::int64_t(value)) : Json(value);
}

Json to_json(int value, Fields) { return value; }

Json to_json(bool value, Fields) { return value; }

Json to_json(const std::string& text, Fields) { return text; }

Json to_json(const glm::dvec3& v, Fields which) {
  return Json::array({to_json(v.x, which), to_json(v.y, which), to_json(v.z, which)});
}

template <NamedEnum T>
Json to_json(T value, Fields) {
  return name_of(value);
}

template <Fielded T>
Json to_json(const T& values, Fields which);

template <class T>
Json to_json(const std::optional<T>& value, Fields which) {
  return value ? to_json(*value, which) : Json(nullptr);
}

template <class T>
Json to_json(const std::vector<T>& values, Fields which) {
  Json array = Json::array();
  for (const T& value : values) array.push_back(to_json(value, which));
  return array;
}

/// What a file had and this version does not know goes where it was.
void add_unknown(Json& object, const Json& unknown) {
  for (const auto& item : unknown.items()) {
    if (object.contains(item.key()) && object[item.key()].is_object() && item.value().is_object())
      add_unknown(object[item.key()], item.value());
    else
      object[item.key()] = item.value();
  }
}

/// The fields of T that need not be written, with their defaults.
template <Fielded T>
Json defaults_of() {
  Json defaults = Json::object();
  const T plain{};
  visit_fields(plain, [&](const char* name, const auto& field, const FieldRule& rule) {
    if (!rule.always_written) defaults[name] = to_json(field, Fields::telling);
  });
  return defaults;
}

template <Fielded T>
Json to_json(const T& values, Fields which) {
  static const Json defaults = defaults_of<T>();
  Json object = Json::object();
  visit_fields(values, [&](const char* name, const auto& field, const FieldRule&) {
    Json json = to_json(field, which);
    const auto plain = defaults.find(name);
    if (which == Fields::all || plain == defaults.end() || json != *plain) object[name] = std::move(json);
  });
  if constexpr (KeepsUnknown<T>) {
    if (!values.unknown.empty()) add_unknown(object, Json::parse(values.unknown));
  }
  return object;
}

}  // namespace

Json preset_to_json(const Preset& preset, Fields which) {
  Json json = {{"format", preset_format}, {"version", preset_version}};
  json.update(to_json(preset, which));
  return json;
}

Json camera_to_json(const Camera& camera, Fields which) { return to_json(camera, which); }

}  // namespace crest
