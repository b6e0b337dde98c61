#include "presets/preset_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "preset_library_embedded.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/exchange/importers.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/nearest_word.h"
#include "presets/preset_json.h"

namespace crest {
namespace {

constexpr std::size_t largest_preset = 16 << 20;  // bytes: some 200,000 points

}  // namespace

Preset parse_preset(std::string_view text, std::string_view source) {
  try {
    if (text.size() > largest_preset)
      throw Error(fmt::format("{} bytes are more than a preset may have, {}", text.size(), largest_preset));
    const Json json = parse_json(text);
    const bool is_preset = json.is_object() && json.contains("transfer_function");
    if (const Importer* importer = is_preset ? nullptr : find_importer(text, "preset.json"))
      throw Error(fmt::format("no preset of Crest's, but one of {}: crest import {} -o PRESET",
                              importer->summary, source));
    Preset preset = preset_from_json(json);
    if (const std::string why_not = why_inconsistent(preset.rendering); !why_not.empty())
      throw Error(why_not);
    return preset;
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", source, error.what()));
  }
}

bool is_own_preset(std::string_view text) {
  try {
    const Json json = parse_json(text);
    return json.is_object() && json.contains("transfer_function");
  } catch (const Error&) {
    return false;
  }
}

std::string write_preset(const Preset& preset) { return print_json(preset_to_json(preset, Fields::telling)); }

Preset load_preset(const std::string& name_or_path) {
  std::error_code ignored;
  if (std::filesystem::exists(name_or_path, ignored))
    return parse_preset(read_file(name_or_path, largest_preset), name_or_path);
  for (const LibraryPreset& preset : library())
    if (preset.name == name_or_path) return parse_preset(preset.text, name_or_path);
  std::vector<std::string_view> names;
  for (const LibraryPreset& preset : library()) names.push_back(preset.name);
  throw Error(fmt::format("{}: no such file, and no preset of that name in the library, which has: {}{}",
                          name_or_path, fmt::join(names, ", "), did_you_mean(name_or_path, names)));
}

void save_preset(const std::filesystem::path& path, const Preset& preset) {
  write_file_atomically(path, write_preset(preset));
}

std::vector<LibraryPreset> library() {
  constexpr std::string_view folder = "library/", extension = ".json";
  std::vector<LibraryPreset> presets;
  for (const auto& file : preset_library::embedded_files()) {
    std::string_view name = file.name.substr(folder.size());
    name.remove_suffix(extension.size());
    presets.push_back({name, file.text});
  }
  std::sort(presets.begin(), presets.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return presets;
}

}  // namespace crest
