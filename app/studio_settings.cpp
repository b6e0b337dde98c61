#include "app/studio_settings.h"

#include <fmt/core.h>

#include "app/user_folders.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/json.h"
#include "presets/number_text.h"

namespace crest {
namespace {

constexpr std::size_t most_bytes = 1 << 16;

using Json = nlohmann::json;

const char* name_of(Theme theme) { return theme == Theme::light ? "light" : "dark"; }

/// Takes what is right, and returns what is not.
std::string take(const Json& json, StudioSettings& settings) {
  if (!json.is_object()) return "it is not a JSON object";
  std::string wrong;
  const auto boolean = [&](const char* key, bool& value) {
    if (!json.contains(key)) return;
    if (json[key].is_boolean())
      value = json[key];
    else
      wrong = fmt::format("{} is neither true nor false", key);
  };
  boolean("data_values", settings.data_values);
  boolean("large_peak_table", settings.large_peak_table);
  if (json.contains("theme")) {
    const auto theme = json["theme"].is_string() ? theme_named(json["theme"]) : std::nullopt;
    settings.theme = theme.value_or(settings.theme);
    if (!theme) wrong = "theme is neither \"dark\" nor \"light\"";
  }
  if (json.contains("scale") && json["scale"] != "automatic") {
    const bool is_right =
        json["scale"].is_number() && why_outside(json["scale"].get<double>(), scale_rule).empty();
    if (is_right) settings.scale = json["scale"].get<double>();
    if (!is_right)
      wrong = fmt::format("scale is neither \"automatic\" nor from {} to {}", scale_rule.min, scale_rule.max);
  }
  return wrong;
}

}  // namespace

std::filesystem::path settings_file() {
  const std::filesystem::path folder = config_folder();
  return folder.empty() ? folder : folder / "settings.json";
}

std::optional<Theme> theme_named(const std::string& name) {
  for (const Theme theme : {Theme::dark, Theme::light})
    if (name == name_of(theme)) return theme;
  return std::nullopt;
}

ReadSettings read_settings(const std::filesystem::path& file) {
  ReadSettings result;
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) return result;
  std::string wrong;
  try {
    const Json json = Json::parse(read_file(file, most_bytes), nullptr, false);
    wrong = json.is_discarded() ? "it is not JSON" : take(json, result.settings);
  } catch (const Error& error) {
    wrong = error.what();
  }
  if (!wrong.empty())
    result.problem = fmt::format(
        "The settings in {} are not all right: {}. The rest is taken; View > Settings writes the file anew.",
        file.string(), wrong);
  return result;
}

void write_settings(const std::filesystem::path& file, const StudioSettings& settings) {
  Json json = Json::object();
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) {
    json = Json::parse(read_file(file, most_bytes), nullptr, false);
    if (!json.is_object()) json = Json::object();
  }
  json["theme"] = name_of(settings.theme);
  json["scale"] = settings.scale ? Json(*settings.scale) : Json("automatic");
  json["data_values"] = settings.data_values;
  json["large_peak_table"] = settings.large_peak_table;
  std::filesystem::create_directories(file.parent_path(), ignored);
  write_file_atomically(file, json.dump(1) + "\n");
}

}  // namespace crest
