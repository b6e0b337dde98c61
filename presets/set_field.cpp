#include <fmt/core.h>

#include <charconv>

#include "presets/error.h"
#include "presets/json.h"
#include "presets/nearest_word.h"
#include "presets/number_text.h"
#include "presets/preset_file.h"
#include "presets/preset_json.h"

namespace crest {
namespace {

std::string keys_of(const Json& object) {
  std::string keys;
  for (const auto& item : object.items()) keys += (keys.empty() ? "" : ", ") + item.key();
  return keys;
}

/// The key at the start of `rest`, up to the next dot or bracket, taken off it.
std::string take_key(std::string_view& rest) {
  const std::string_view key = rest.substr(0, rest.find_first_of(".["));
  rest.remove_prefix(key.size());
  return std::string(key);
}

/// The index of "[3]" at the start of `rest`, taken off it.
std::size_t take_index(std::string_view& rest, std::string_view path) {
  std::size_t index = 0;
  const char* const end = rest.data() + rest.size();
  const auto [stop, error] = std::from_chars(rest.data() + 1, end, index);
  if (error != std::errc{} || stop == end || *stop != ']')
    throw Error(fmt::format("{}: an index is written like [0]", path));
  rest.remove_prefix(std::size_t(stop + 1 - rest.data()));
  return index;
}

std::string meant_key(const Json& object, std::string_view key) {
  std::vector<std::string_view> keys;
  for (const auto& item : object.items()) keys.push_back(item.key());
  return did_you_mean(key, keys);
}

/// The member that `path` names, which must be there.
Json& find(Json& root, std::string_view path) {
  Json* json = &root;
  std::string_view rest = path;
  while (!rest.empty()) {
    const std::string_view so_far = path.substr(0, path.size() - rest.size());
    if (rest.front() == '[') {
      const std::size_t index = take_index(rest, path);
      if (!json->is_array()) throw Error(fmt::format("{}: {} is not an array", path, so_far));
      if (index >= json->size())
        throw Error(fmt::format("{}: {} has {} elements, counted from 0", path, so_far, json->size()));
      json = &(*json)[index];
    } else {
      if (rest.front() == '.' && !so_far.empty()) rest.remove_prefix(1);
      const std::string key = take_key(rest);
      if (!json->is_object()) throw Error(fmt::format("{}: {} has no fields", path, so_far));
      if (!json->contains(key))
        throw Error(fmt::format("{}: no field \"{}\"; {} has: {}{}", path, key,
                                so_far.empty() ? "a preset" : so_far, keys_of(*json), meant_key(*json, key)));
      json = &(*json)[key];
    }
  }
  return *json;
}

/// What is no JSON: a number as people write it, for a field that holds one; else a text without quotes.
Json as_typed(std::string_view value, const Json& before, std::string_view path) {
  if (before.is_string()) return value;
  const TypedNumber typed = read_number(value);
  if (typed.number) return *typed.number;
  if (before.is_number()) throw Error(fmt::format("{}: {}", path, typed.wrong));
  return value;
}

}  // namespace

Preset set_field(const Preset& preset, std::string_view path_and_value) {
  const std::size_t equals = path_and_value.find('=');
  if (equals == std::string_view::npos || equals == 0)
    throw Error(fmt::format("{}: a field is set by PATH=VALUE, as in rendering.step=0.5", path_and_value));
  const std::string_view path = path_and_value.substr(0, equals), value = path_and_value.substr(equals + 1);

  Json json = preset_to_json(preset, Fields::all);
  if (path.starts_with("camera.") && json["camera"].is_null())
    json["camera"] = camera_to_json({}, Fields::all);
  if (path.starts_with("rendering.clip_box.") && !preset.rendering.clip_box)
    throw Error(
        fmt::format("{}: there is no clip box yet; set it whole, as in "
                    "rendering.clip_box={{\"min\":[0,0,0],\"max\":[1,1,1]}}",
                    path));
  Json& field = find(json, path);
  field = Json::accept(value) ? parse_json(value) : as_typed(value, field, path);
  return preset_from_json(std::move(json));
}

std::vector<std::string> assignments_between(const Rendering& from, const Rendering& to) {
  const auto json_of = [](const Rendering& rendering) {
    Preset preset;
    preset.rendering = rendering;
    return preset_to_json(preset, Fields::all)["rendering"];
  };
  const Json before = json_of(from), after = json_of(to);
  std::vector<std::string> assignments;
  for (const auto& [name, value] : after.items())
    if (!before.contains(name) || before[name] != value)
      assignments.push_back(
          fmt::format("rendering.{}={}", name, value.is_string() ? value.get<std::string>() : value.dump()));
  return assignments;
}

}  // namespace crest
