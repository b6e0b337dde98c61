#include "app/user_folders.h"

#include <cstdlib>

namespace crest {
namespace fs = std::filesystem;
namespace {

/// As the XDG base directory specification has it, a relative one is passed over: it would be another folder
/// in every working folder.
fs::path absolute_folder(const char* variable) {
  const char* const value = std::getenv(variable);
  const fs::path folder = value ? value : "";
  return folder.is_absolute() ? folder : fs::path();
}

}  // namespace

std::filesystem::path user_folder(const char* variable, const char* in_home) {
  const fs::path folder = absolute_folder(variable), home = absolute_folder("HOME");
  if (!folder.empty()) return folder / "crest";
  if (!home.empty()) return home / in_home / "crest";
  return {};
}

std::filesystem::path config_folder() { return user_folder("XDG_CONFIG_HOME", ".config"); }
std::filesystem::path state_folder() { return user_folder("XDG_STATE_HOME", ".local/state"); }
std::filesystem::path data_folder() { return user_folder("XDG_DATA_HOME", ".local/share"); }

std::filesystem::path recovery_folder() {
  const std::filesystem::path state = state_folder();
  return state.empty() ? state : state / "recovery";
}

std::filesystem::path own_preset_folder() {
  const std::filesystem::path data = data_folder();
  return data.empty() ? data : data / "presets";
}

}  // namespace crest
