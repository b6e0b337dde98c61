#pragma once

#include <filesystem>
#include <vector>

namespace crest {

/// Makes a folder, and those above it, unless they are there: those that are new, the outermost first. Throws
/// Error where that is not possible, or nothing can be written into it; then nothing is left of it.
std::vector<std::filesystem::path> make_folder(const std::filesystem::path& path);

/// The folder that a command writes its files into: made before any work, so that a wrong one is told at
/// once. What is new of it and those above it is taken away in the end if nothing came into it.
class OutputFolder {
 public:
  explicit OutputFolder(const std::filesystem::path& path) : made_(make_folder(path)) {}
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  std::vector<std::filesystem::path> made_;
};

}  // namespace crest
