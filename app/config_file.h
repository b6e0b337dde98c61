#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/option_table.h"

namespace crest {

/// $XDG_CONFIG_HOME/crest/config.json; empty where there is no such folder.
std::filesystem::path config_file();

/// Sets the defaults of the command line from the config file, where there is one. Throws Error.
void read_config_file(OptionTable& table);

/// The same from a JSON text that `source` names in errors. Its keys are long names without their dashes: at
/// the top for all commands that have such an option, within the name of a command for it alone ("window" is
/// the program without a command). Throws Error for a key that there is not, with the nearest one, and for a
/// value that the option does not take. An argument, and what must be given, has no default.
void apply_config(OptionTable& table, std::string_view text, const std::string& source);

/// The values that a row has now, as the command line would give them.
std::vector<std::string> values_of(const OptionRow& row);

}  // namespace crest
