#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace crest {

/// A volume's source, or a preset's path, that means the same in every working folder. Built-in volumes stay
/// as they are.
std::string absolute_source(const std::string& source);

/// The file or folder that a volume's or a preset's source names, or the files of a numbered list, to be
/// watched; none where it is built in.
std::vector<std::filesystem::path> files_of(const std::string& source);

/// Throws UsageError where a command's output is a file of the volume or preset that it reads, which would be
/// lost.
void require_other_file(const std::filesystem::path& output, const std::string& read,
                        const char* option = "--output");

/// The built-in volumes as sources, and the names of the library's presets: what completions offer.
std::vector<std::string> builtin_sources();
std::vector<std::string> library_names();

}  // namespace crest
