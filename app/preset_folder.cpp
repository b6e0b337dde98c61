#include "app/preset_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "app/trash.h"
#include "app/user_folders.h"
#include "presets/error.h"
#include "presets/preset_file.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 80;  // bytes
constexpr std::size_t most_items = 1000;

}  // namespace

std::string title_of(const Preset& preset, const std::string& file_name) {
  return preset.name.empty() ? file_name : preset.name;
}

std::string file_name_for(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || byte >= 0x80)
      name += byte < 0x80 ? char(std::tolower(byte)) : c;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  if (name.size() > longest_name) {
    name.resize(longest_name);
    // The start of a character of UTF-8 that was cut goes with it
    while (!name.empty() && (name.back() & 0xC0) == 0x80) name.pop_back();
    if (!name.empty() && (name.back() & 0x80)) name.pop_back();
  }
  while (name.ends_with('-')) name.pop_back();
  return name.empty() ? "preset" : name;
}

void PresetFolder::read_again() {
  items_.clear();
  std::error_code error;
  for (fs::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->path().extension() != ".json" || !entry->is_regular_file(ignored) ||
        items_.size() == most_items)
      continue;
    try {
      items_.push_back({entry->path(), load_preset(entry->path().string())});
    } catch (const std::exception&) {
      // none of ours
    }
  }
  std::ranges::sort(items_, {}, [](const Item& item) {
    return std::pair(title_of(item.preset, item.path.stem().string()), item.path);
  });
}

fs::path PresetFolder::free_name(const std::string& title) const {
  const std::string name = file_name_for(title);
  fs::path path = folder_ / (name + ".json");
  for (int i = 2; fs::exists(path); ++i) path = folder_ / fmt::format("{}-{}.json", name, i);
  return path;
}

fs::path PresetFolder::add(const Preset& preset) {
  if (folder_.empty()) throw Error("there is no folder for presets of your own: HOME is not set");
  std::error_code error;
  fs::create_directories(folder_, error);
  const fs::path path = free_name(title_of(preset, "preset"));
  save_preset(path, preset);
  read_again();
  return path;
}

fs::path PresetFolder::rename(const fs::path& file, const std::string& title) {
  Preset preset = load_preset(file.string());
  preset.name = title;
  fs::path path = file;
  if (file_name_for(title) != file.stem()) path = free_name(title);
  save_preset(path, preset);
  if (path != file) {
    std::error_code error;
    fs::remove(file, error);
  }
  read_again();
  return path;
}

fs::path PresetFolder::duplicate(const fs::path& file) {
  Preset preset = load_preset(file.string());
  preset.name = "Copy of " + title_of(preset, file.stem().string());
  return add(preset);
}

void PresetFolder::remove(const fs::path& file) {
  move_to_trash(file, data_folder().parent_path());
  read_again();
}

}  // namespace crest
