#pragma once

#include <filesystem>

namespace crest {

// Where the program keeps what is a person's own, as the XDG base directory specification says. Each is empty
// where neither its variable nor HOME is set, and need not exist.

/// $XDG_CONFIG_HOME/crest, or ~/.config/crest.
std::filesystem::path config_folder();
/// What a run leaves for the next one: $XDG_STATE_HOME/crest, or ~/.local/state/crest.
std::filesystem::path state_folder();
/// What the person made: $XDG_DATA_HOME/crest, or ~/.local/share/crest.
std::filesystem::path data_folder();

/// The part of the state folder for unsaved changes (RecoveryFile).
std::filesystem::path recovery_folder();

/// The part of the data folder for presets of a person's own.
std::filesystem::path own_preset_folder();

/// $VARIABLE/crest, or $HOME/`in_home`/crest.
std::filesystem::path user_folder(const char* variable, const char* in_home);

}  // namespace crest
