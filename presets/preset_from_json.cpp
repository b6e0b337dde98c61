#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include "presets/error.h"
#include "presets/fields.h"
#include "presets/json.h"
#include "presets/names.h"
#include "presets/nearest_word.h"
#include "presets/number_text.h"
#include "presets/preset_json.h"
#include "presets/printable.h"

namespace crest {
namespace {

/// Where a value is in the preset: a chain along the calls, made into text only for an error.
struct Path {
  const Path* parent = nullptr;
  std::string_view key = {};  ///< a field's name; without one, an element
  std::size_t index = 0;

  std::string text() const {
    if (!parent) return std::string(key);
    const std::string before = parent->text();
    return key.empty() ? fmt::format("{}[{}]", before, index) : join_path(before, key);
  }
};

[[noreturn]] void fail(const Path& path, const std::string& what) {
  const std::string text = path.text();
  throw Error(text.empty() ? what : text + ": " + what);
}

// read(json, path, value, rule) reads one field of each type.

void read(const Json& json, const Path& path, double& value, const FieldRule& rule) {
  if (!json.is_number()) fail(path, fmt::format("{} is not a number", summary_of(json)));
  value = json.get<double>();
  for (const FieldRule& each : {any_value, rule})
    if (const std::string why = why_outside(value, each); !why.empty())
      fail(path, fmt::format("{} {}", summary_of(json), why));
}

void read(const Json& json, const Path& path, int& value, const FieldRule& rule) {
  double number = 0;
  read(json, path, number, rule);
  if (number != std::trunc(number)) fail(path, fmt::format("{} is not a whole number", summary_of(json)));
  value = int(number);
}

void read(const Json& json, const Path& path, bool& value, const FieldRule&) {
  if (!json.is_boolean()) fail(path, fmt::format("{} is not true or false", summary_of(json)));
  value = json.get<bool>();
}

void read(const Json& json, const Path& path, std::string& text, const FieldRule&) {
  if (!json.is_string()) fail(path, fmt::format("{} is not a text in quotes", summary_of(json)));
  const auto& told = json.get_ref<const std::string&>();
  if (!is_utf8(told))
    fail(path, fmt::format("\"{}\" is no UTF-8", printable(told)));  // which a file cannot hold
  text = told;
}

void read(const Json& json, const Path& path, std::vector<std::string>& texts, const FieldRule& rule) {
  if (!json.is_array()) fail(path, fmt::format("{} is not an array of texts", summary_of(json)));
  texts.clear();
  for (const Json& element : json) {
    const Path element_path{&path, {}, texts.size()};
    read(element, element_path, texts.emplace_back(), rule);
  }
}

void read(const Json& json, const Path& path, glm::dvec3& vector, const FieldRule& rule) {
  if (!json.is_array() || json.size() != 3)
    fail(path, fmt::format("{} is not an array of 3 numbers", summary_of(json)));
  for (int i = 0; i < 3; ++i) read(json[std::size_t(i)], Path{&path, {}, std::size_t(i)}, vector[i], rule);
}

template <NamedEnum T>
void read(const Json& json, const Path& path, T& value, const FieldRule&) {
  const std::optional<T> named =
      json.is_string() ? value_named<T>(json.get_ref<const std::string&>()) : std::nullopt;
  if (!named) {
    std::vector<std::string_view> names;
    for (const auto& known : names_of<T>()) names.push_back(known.name);
    const std::string meant = json.is_string() ? did_you_mean(json.get<std::string>(), names) : "";
    fail(path, fmt::format("{} is not one of: {}{}", summary_of(json), name_list<T>(), meant));
  }
  value = *named;
}

template <Fielded T>
Json read(const Json& json, const Path& path, T& values, const FieldRule&);

/// What one field's rule cannot say.
void check_whole(const ClipBox& box, const Path& path) {
  for (int i = 0; i < 3; ++i)
    if (!(box.min[i] < box.max[i]))
      fail(path, fmt::format("min {} is not less than max {} on axis {}", box.min[i], box.max[i], "xyz"[i]));
}
void check_whole(const VdlsOptions& options, const Path& path) {
  if (options.leaves > 0 && !std::has_single_bit(unsigned(options.leaves)))
    fail(Path{&path, "leaves"}, fmt::format("{} is neither a power of two nor 0", options.leaves));
}
template <class T>
void check_whole(const T&, const Path&) {}

template <class T>
void read(const Json& json, const Path& path, std::optional<T>& value, const FieldRule& rule) {
  value.reset();
  if (!json.is_null()) read(json, path, value.emplace(), rule);
}

void read(const Json& json, const Path& path, std::vector<ControlPoint>& points, const FieldRule& rule) {
  if (!json.is_array()) fail(path, fmt::format("{} is not an array of points", summary_of(json)));
  if (json.empty()) fail(path, "holds no point: a transfer function needs at least one");
  points.clear();
  points.reserve(json.size());
  for (const Json& element : json) {
    const Path point_path{&path, {}, points.size()};
    ControlPoint point;
    read(element, point_path, point, rule);
    if (!points.empty() && point.value < points.back().value)
      fail(Path{&point_path, "value"},
           fmt::format("{} is less than the value before it, {}; values must not decrease", point.value,
                       points.back().value));
    points.push_back(std::move(point));
  }
}

/// Returns the keys that `values` cannot keep itself.
template <Fielded T>
Json read(const Json& json, const Path& path, T& values, const FieldRule&) {
  if (!json.is_object()) fail(path, fmt::format("{} is not an object", summary_of(json)));
  std::set<std::string_view> known;
  Json unknown = Json::object();
  visit_fields(values, [&](const char* name, auto& field, const FieldRule& rule) {
    const Path field_path{&path, name};
    const auto found = json.find(name);
    if (found == json.end()) {
      if (rule.required) fail(field_path, "is missing");
      return;
    }
    known.insert(name);
    if constexpr (Fielded<std::remove_reference_t<decltype(field)>>) {
      Json rest = read(*found, field_path, field, rule);
      if (!rest.empty()) unknown[name] = std::move(rest);
    } else {
      read(*found, field_path, field, rule);
    }
  });
  for (const auto& item : json.items())
    if (!known.contains(item.key())) unknown[item.key()] = item.value();
  check_whole(values, path);
  if constexpr (KeepsUnknown<T>) {
    values.unknown = unknown.empty() ? "" : unknown.dump();
    return Json::object();
  }
  return unknown;
}

}  // namespace

Preset preset_from_json(Json json) {
  if (!json.is_object()) fail(Path{}, fmt::format("{} is not an object", summary_of(json)));
  if (const auto format = json.find("format"); format != json.end() && *format != preset_format)
    fail(Path{nullptr, "format"}, fmt::format("{} is not \"{}\"", summary_of(*format), preset_format));
  if (const auto version = json.find("version"); version != json.end() && *version != preset_version)
    fail(Path{nullptr, "version"}, version->is_number_integer() && *version > preset_version
                                       ? fmt::format("{} is of a newer Crest: this one reads up to {}",
                                                     summary_of(*version), preset_version)
                                       : fmt::format("{} is not {}, the version that this program reads",
                                                     summary_of(*version), preset_version));
  json.erase("format");
  json.erase("version");
  Preset preset;
  read(json, Path{}, preset, any_value);
  return preset;
}

}  // namespace crest
