#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "ui/settings.h"

namespace crest {

/// Where the studio keeps what a person chose: settings.json of the configuration folder; empty where there
/// is none.
std::filesystem::path settings_file();

struct ReadSettings {
  StudioSettings settings;  ///< the defaults for what is not there or wrong
  std::string problem;      ///< with the file, in one sentence; empty where there is none, or no file
};
ReadSettings read_settings(const std::filesystem::path& file);

/// The file appears whole or stays as it was; keys that are not known here stay in it. Throws Error.
void write_settings(const std::filesystem::path& file, const StudioSettings& settings);

/// "dark" or "light", as in the file and on the command line.
std::optional<Theme> theme_named(const std::string& name);

}  // namespace crest
