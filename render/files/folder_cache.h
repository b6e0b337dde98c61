#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace crest {

/// Files that can be made again, all of one extension in a folder, which programs may share. What a cache
/// cannot do is no error: a file that is damaged counts as none, and where none can be written it is made
/// again each time.

/// What write_cached left in `file`, if it is there, whole, and of at most `most_bytes`. It counts as used
/// now.
std::optional<std::string> read_cached(const std::filesystem::path& file, std::uintmax_t most_bytes);

/// Writes a file, whole or not at all. The folder's files of its extension keep to `limit_bytes` together;
/// the ones that were used longest ago go first.
void write_cached(const std::filesystem::path& file, std::string content, std::uintmax_t limit_bytes);

}  // namespace crest
