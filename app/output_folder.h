#pragma once

#include <filesystem>
#include <vector>

namespace crest {

/// The folder that a command's files go into. It is made before any work, with those above it that are
/// missing, so that a wrong one is found at once; what was made goes again in the end if nothing came into
/// it.
class OutputFolder {
 public:
  /// Throws Error where there can be no such folder, or nothing can be written into it.
  explicit OutputFolder(std::filesystem::path path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  void make();
  void remove_empty();

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  ///< the outermost first
};

}  // namespace crest
