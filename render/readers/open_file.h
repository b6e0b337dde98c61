#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>

namespace crest {

/// To read bytes from `offset` on. Throws Error where it cannot be opened.
std::ifstream open_file(const std::filesystem::path& path, std::uint64_t offset = 0);

}  // namespace crest
