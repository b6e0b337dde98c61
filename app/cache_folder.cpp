#include "app/cache_folder.h"

#include "app/user_folders.h"

namespace crest {

std::filesystem::path cache_folder() { return user_folder("XDG_CACHE_HOME", ".cache"); }

std::filesystem::path program_folder() {
  const std::filesystem::path cache = cache_folder();
  return cache.empty() ? cache : cache / "programs";
}

}  // namespace crest
