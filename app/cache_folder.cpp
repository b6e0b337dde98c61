#include "app/cache_folder.h"

#include <cstdlib>

namespace crest {

std::filesystem::path cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if (cache && *cache) return std::filesystem::path(cache) / "crest";
  if (home && *home) return std::filesystem::path(home) / ".cache" / "crest";
  return {};
}

}  // namespace crest
