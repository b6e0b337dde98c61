#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "presets/preset.h"

namespace crest {

/// The presets of a person's own: the .json files of a folder, which need not be there.
class PresetFolder {
 public:
  struct Item {
    std::filesystem::path path;
    Preset preset;
  };

  explicit PresetFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Those that can be read, by title.
  const std::vector<Item>& items() const { return items_; }
  void read_again();

  // Each reads the folder again. They throw Error, and nothing has changed then.

  /// A new file, named by the preset's title; returns it.
  std::filesystem::path add(const Preset& preset);
  /// The preset's name, and its file's by that. Returns the new file.
  std::filesystem::path rename(const std::filesystem::path& file, const std::string& title);
  /// A copy, named so.
  std::filesystem::path duplicate(const std::filesystem::path& file);
  /// To the bin, from which it can be brought back.
  void remove(const std::filesystem::path& file);

 private:
  std::filesystem::path free_name(const std::string& title) const;

  std::filesystem::path folder_;
  std::vector<Item> items_;
};

/// The preset's name, or its file's.
std::string title_of(const Preset& preset, const std::string& file_name);

/// A file's name without its extension for a title: letters, digits and bytes of UTF-8 stay, the rest becomes
/// '-'.
std::string file_name_for(const std::string& title);

}  // namespace crest
