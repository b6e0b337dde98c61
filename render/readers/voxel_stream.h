#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "render/readers/voxel_data.h"

namespace crest {

/// Bytes of one file, which are asked for in their order.
class ByteStream {
 public:
  virtual ~ByteStream() = default;
  /// Fills `out` with those from `first` on, which is no less than where the last call ended.
  virtual void read(std::uint64_t first, std::span<std::byte> out) = 0;
  /// Checks what was not asked for. Whether the file goes on behind its voxels.
  virtual bool finish() { return false; }
};

/// The stored values that a header tells of, as they are asked for: in the byte order that the file has them
/// in; of text, in the machine's. Raw files are read where the values are, others from their begin. No more
/// than some hundred KB are held.
class VoxelStream {
 public:
  /// There are `values` altogether. `name` begins the errors.
  VoxelStream(std::string name, const VoxelData& data, ScalarType type, std::uint64_t values);
  /// Fills `out` with the values from `first` on, which is no less than where the last call ended. Throws
  /// Error when the files do not hold them, are damaged, or hold text that is no number of the type.
  void read(std::uint64_t first, std::span<std::byte> out);
  /// Checks what was not asked for: of compressed files that were read the checksum, of text all numbers.
  /// Which file goes on behind its voxels, the first of those that were read.
  std::optional<std::filesystem::path> finish();

 private:
  void open(std::uint64_t file);
  void close();

  std::string name_;
  const VoxelData& data_;
  ScalarType type_;
  std::uint64_t share_;     ///< values of each file
  std::uint64_t next_ = 0;  ///< the file after the open one
  std::unique_ptr<ByteStream> stream_;
  std::optional<std::filesystem::path> goes_on_;
};

}  // namespace crest
