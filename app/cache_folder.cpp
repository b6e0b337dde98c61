#include "app/cache_folder.h"

#include <unistd.h>

#include <cstdint>
#include <cstdlib>

#include "app/user_folders.h"

namespace crest {

std::filesystem::path cache_folder() { return user_folder("XDG_CACHE_HOME", ".cache"); }

namespace {

std::filesystem::path part(const char* name) {
  const std::filesystem::path cache = cache_folder();
  return cache.empty() ? cache : cache / name;
}

}  // namespace

void tell_driver_of_cache() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  fs::path there = cache_folder().parent_path();  // where it is, or where it will be made
  while (there.has_relative_path() && !fs::exists(there, ignored)) there = there.parent_path();
  // On a full disk its mapped index would be a bus error, in a thread that lets no signal be handled
  constexpr std::uintmax_t room = std::uintmax_t(64) << 20;
  const bool can_hold_files = fs::is_directory(there, ignored) && ::access(there.c_str(), W_OK | X_OK) == 0 &&
                              fs::space(there, ignored).available >= room;
  if (!can_hold_files) ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
}

std::filesystem::path program_folder() { return part("programs"); }
std::filesystem::path thumbnail_folder() { return part("thumbnails"); }

}  // namespace crest
