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

std::filesystem::path program_folder() {
  const std::filesystem::path cache = cache_folder();
  return cache.empty() ? cache : cache / "programs";
}

}  // namespace crest
