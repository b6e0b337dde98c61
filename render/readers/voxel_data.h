#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// Of the deflate format, in bytes out for one in.
inline constexpr std::uint64_t greatest_inflation = 1032;

/// How the voxels are written: as they are, as a zlib or gzip stream, or as text.
enum class Encoding { raw, deflate, decimal, hexadecimal };

/// Where a header says its voxels are: in equal parts in `files`, in each from `offset` on.
struct VoxelData {
  std::vector<std::filesystem::path> files = {};
  std::uint64_t offset = 0;
  Encoding encoding = Encoding::raw;
  std::uint64_t skip = 0;        ///< bytes before the voxels, counted in the inflated stream
  bool at_file_end = false;      ///< raw voxels that end where their file does: `offset` says nothing
  std::size_t first_line = 1;    ///< of text: the line of the file that `offset` is in
  bool more_may_follow = false;  ///< behind the voxels, as other arrays do
};

/// Throws Error, which begins with `name`, when a file is missing or the files cannot hold `values` numbers
/// of `value_size` bytes. Cheap: compressed data is held against the most that it can inflate to.
void require_room(const std::string& name, const VoxelData& data, std::uint64_t values,
                  std::uint64_t value_size);

/// Compressed data that is far longer than the voxels is not inflated to find where they begin.
inline constexpr std::uint64_t longest_skip = std::uint64_t(1) << 24;

/// Bytes of a file behind `offset`. Throws Error when it cannot be read.
std::uint64_t bytes_from(const std::string& name, const std::filesystem::path& path, std::uint64_t offset);
/// Of `values`, how many are in each file. Throws Error when they are not of one length.
std::uint64_t share_of(const std::string& name, const VoxelData& data, std::uint64_t values);
/// The Error for files that hold less than they should; `unit`: "bytes".
[[noreturn]] void throw_short(const std::string& name, const VoxelData& data, std::uint64_t promised,
                              std::uint64_t held, std::string_view unit);

/// As read_head() of header_text.h; of a gzip stream, inflated, if `inflate`.
std::string read_head(const std::filesystem::path& path, std::size_t size, bool inflate);

}  // namespace crest
