#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// How the voxels are written: as they are, as a zlib or gzip stream, or as text.
enum class Encoding { raw, deflate, decimal, hexadecimal };

/// Where a header says its voxels are: in equal parts in `files`, in each from `offset` on.
struct VoxelData {
  std::vector<std::filesystem::path> files = {};
  std::uint64_t offset = 0;
  Encoding encoding = Encoding::raw;
  std::uint64_t skip = 0;      ///< bytes before the voxels, counted in the inflated stream
  bool at_file_end = false;    ///< raw voxels that end where their file does: `offset` says nothing
  std::size_t first_line = 1;  ///< of text: the line of the file that `offset` is in
};

/// Throws Error, which begins with `name`, when a file is missing or the files cannot hold `values` numbers
/// of `value_size` bytes. Cheap: compressed data is held against the most that it can inflate to.
void require_room(const std::string& name, const VoxelData& data, std::uint64_t values,
                  std::uint64_t value_size);

/// The bytes of the values [first, first + taken) of `values`, in the byte order that the file has them in;
/// of text, in the machine's. Compressed data is inflated whole, to its checksum. Throws Error, which begins
/// with `name`, when the files do not hold them all, are damaged, or hold text that is no number of the type.
std::vector<std::byte> read_stored(const std::string& name, const VoxelData& data, ScalarType type,
                                   std::uint64_t values, std::uint64_t first, std::uint64_t taken);

/// The first bytes of a file, at most `size`; of a gzip stream, inflated, if `inflate`.
std::string read_head(const std::filesystem::path& path, std::size_t size, bool inflate = false);

}  // namespace crest
