#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace crest {

/// Writes `content` beside `path` and renames it there, so that the file appears whole or not at all, also if
/// the program is killed or the power fails; what stood there stays until then. Its permissions are kept, and
/// its owner and group where the system lets one give files away. A symbolic link is followed, one that leads
/// nowhere too; a device or a pipe is written to as it is. Throws Error when that fails (no folder, no
/// permission, a full disk).
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// The same without waiting for the disk: after a power failure the file may be empty. For what is checked
/// when it is read, and can be made again.
void replace_file(const std::filesystem::path& path, std::string_view content);

/// Throws Error where write_file_atomically() would at once: no folder, no permission, a folder of that name.
void require_writable(const std::filesystem::path& path);

/// The whole file. Throws Error when it cannot be read, is a folder, or is larger than `size_limit` bytes.
std::string read_file(const std::filesystem::path& path, std::size_t size_limit);

}  // namespace crest
