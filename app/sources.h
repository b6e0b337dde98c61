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

/// A file that a command writes, and the option that says so.
struct OutputFile {
  const char* option;
  std::filesystem::path path;  ///< empty: the option is not given
};
/// Throws UsageError where an output is a file of a volume or a preset that is read, which would be lost, or
/// where two outputs are one file. Devices and pipes lose nothing.
void require_other_files(const std::vector<OutputFile>& outputs, const std::vector<std::string>& read);

/// The built-in volumes as sources, and the names of the library's presets: what completions offer.
std::vector<std::string> builtin_sources();
std::vector<std::string> library_names();

}  // namespace crest
