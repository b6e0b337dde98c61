#pragma once

#include <cstdint>
#include <filesystem>

namespace crest {

/// What reading a file may take of the machine, from what it holds and what it promises. A process that takes
/// more memory gets std::bad_alloc; one that takes more processor time ends with SIGPROF.
class Limits {
 public:
  Limits();  ///< counts from what the process takes now
  /// Allows for reading what takes so many bytes. Returns the seconds of processor time from now on.
  double allow(std::uint64_t bytes) const;

 private:
  std::uint64_t taken_;  ///< bytes of address space
};

/// Bytes of a file, or of those in a folder; where there are many, each counts a little more.
std::uint64_t bytes_held(const std::filesystem::path& path);

}  // namespace crest
