#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace crest {

/// Writes `content` beside `path` and renames it there, so that the file appears whole or not at all; what
/// stood there stays until then, and its permissions are kept. A symbolic link is followed; a device or a
/// pipe is written to as it is. Throws Error when that fails (no folder, no permission, a full disk).
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// The same for writers that want a file name of their own: `write` fills the temporary file (which has the
/// same extension) and throws Error if it cannot.
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(const std::filesystem::path& temporary)>& write);

/// Throws Error where write_file_atomically() would at once: no folder, no permission, a folder of that name.
void require_writable(const std::filesystem::path& path);

/// The whole file. Throws Error when it cannot be read, is a folder, or is larger than `size_limit` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t size_limit);

}  // namespace crest
