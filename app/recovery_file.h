#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/recovery_text.h"

namespace crest {

/// A lock on a file (flock), which the system releases however the program ends.
class FileLock {
 public:
  /// Makes the file. Nothing while another program holds it, or where there are no such locks.
  static std::optional<FileLock> take(const std::filesystem::path& path);
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

 private:
  explicit FileLock(int fd) : fd_(fd) {}
  int fd_ = -1;
};

/// A file in which a program keeps its document while that has unsaved changes, so that they outlive the
/// program. Each belongs to one running program, which holds a lock on a file beside it. The file stays
/// unless it is removed.
class RecoveryFile {
 public:
  /// A new one, with nothing in it. Makes the folder. Throws Error.
  explicit RecoveryFile(const std::filesystem::path& folder);

  /// Those that no running program holds, the newest first; from here on this one does. Of more than
  /// most_recoveries that can be read the oldest are removed; others - damaged, of another version - stay. A
  /// folder that is not there has none.
  static std::vector<RecoveryFile> left_behind(const std::filesystem::path& folder);

  /// Throws Error; the file is then as it was.
  void write(const KeptDocument& kept) const;
  /// Throws Error where it is none of ours.
  KeptDocument read() const;
  void remove() const;
  const std::filesystem::path& path() const { return path_; }

 private:
  RecoveryFile(std::filesystem::path path, FileLock lock);
  std::filesystem::path path_;
  FileLock lock_;
};

inline constexpr std::size_t most_recoveries = 8;

}  // namespace crest
