#include "app/user_folders.h"

#include <cstdlib>

namespace crest {

std::filesystem::path user_folder(const char* variable, const char* in_home) {
  const char* folder = std::getenv(variable);
  const char* home = std::getenv("HOME");
  if (folder && *folder) return std::filesystem::path(folder) / "crest";
  if (home && *home) return std::filesystem::path(home) / in_home / "crest";
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
