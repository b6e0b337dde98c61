#pragma once

#include <filesystem>

namespace crest {

/// Makes a folder, and those above it, unless it is there: whether it is new. Throws Error.
bool make_folder(const std::filesystem::path& folder);

/// The folder that a command writes its files into: made before any work, so that a wrong one is told at
/// once, and taken away in the end if it is new and nothing came into it.
class OutputFolder {
 public:
  explicit OutputFolder(std::filesystem::path folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  std::filesystem::path folder_;
  bool is_new_;
};

}  // namespace crest
