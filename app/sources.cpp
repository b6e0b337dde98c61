#include "app/sources.h"

#include <filesystem>

namespace crest {

std::string absolute_source(const std::string& source) {
  if (source.empty() || source.starts_with("builtin:")) return source;
  return std::filesystem::absolute(source).lexically_normal().string();  // a query at the end stays there
}

}  // namespace crest
