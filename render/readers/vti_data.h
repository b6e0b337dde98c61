#pragma once

#include <bit>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <streambuf>
#include <string>

#include "render/readers/voxel_stream.h"

namespace crest {

/// How the arrays of a VTK XML file are written.
struct VtiCoding {
  bool compressed = false;  ///< by zlib, in blocks
  std::endian endian = std::endian::little;
  std::size_t header_bytes = 4;  ///< of each number that says a length
};

/// The bytes of an array as the file has them, with what says their lengths, from its begin on.
class VtiBytes {
 public:
  virtual ~VtiBytes() = default;
  /// Fills `out` as far as there are some, and returns how far.
  virtual std::size_t read(std::span<std::byte> out) = 0;
  virtual void skip(std::uint64_t count) = 0;
  /// How many there are, where that is known.
  virtual std::optional<std::uint64_t> left() const { return std::nullopt; }
};
std::unique_ptr<VtiBytes> raw_vti_bytes(const std::filesystem::path& file, std::uint64_t offset);
std::unique_ptr<VtiBytes> base64_vti_bytes(std::unique_ptr<std::streambuf> text);

/// The values of one array, `promised` bytes of the type, in the machine's byte order. Of compressed ones a
/// block is held, and blocks that are passed over are not inflated. Throws Error, which begins with `name`,
/// when the array has another length or is damaged, and
/// at once where the file ends before it does.
std::unique_ptr<ByteStream> open_vti_array(const std::string& name, std::unique_ptr<VtiBytes> bytes,
                                           const VtiCoding& coding, ScalarType type, std::uint64_t promised);

}  // namespace crest
