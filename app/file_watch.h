#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace crest {

/// Tells when files change, by their times and sizes, which are looked at whenever it is asked.
class FileWatch {
 public:
  /// True once after a change that rests: as it was when last asked, so that nobody reads a file that is
  /// still being written. False at the first call, for other files than at the last one, and while one is not
  /// there.
  bool has_changed(const std::vector<std::filesystem::path>& files);

 private:
  struct Look {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool is_there = false;
    bool operator==(const Look&) const = default;
  };
  static std::vector<Look> look_at(const std::vector<std::filesystem::path>& files);

  std::vector<std::filesystem::path> files_;
  std::vector<Look> told_, last_;
};

}  // namespace crest
