#include "app/cache_folder.h"

#include "app/user_folders.h"

namespace crest {

std::filesystem::path cache_folder() { return user_folder("XDG_CACHE_HOME", ".cache"); }

namespace {

std::filesystem::path part(const char* name) {
  const std::filesystem::path cache = cache_folder();
  return cache.empty() ? cache : cache / name;
}

}  // namespace

std::filesystem::path program_folder() { return part("programs"); }
std::filesystem::path thumbnail_folder() { return part("thumbnails"); }

}  // namespace crest
