#include "render/readers/open_file.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>

#include "presets/error.h"

namespace crest {

std::ifstream open_file(const std::filesystem::path& path, std::uint64_t offset) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw Error(fmt::format("{}: it cannot be opened{}{}", path.string(), errno ? ": " : "",
                            errno ? std::strerror(errno) : ""));
  file.seekg(std::streamoff(offset));
  return file;
}

}  // namespace crest
