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

/// Where a header says its voxels are: one after another in `files`, each from `offset` on.
struct VoxelData {
  std::vector<std::filesystem::path> files = {};
  std::uint64_t offset = 0;
  Encoding encoding = Encoding::raw;
  std::uint64_t skip = 0;  ///< bytes before the voxels, counted in the inflated stream
};

/// Throws Error, which begins with `name`, when a file is missing or the files cannot hold `values` numbers
/// of `value_size` bytes. Cheap: compressed data is held against the most that it can inflate to.
void require_room(const std::string& name, const VoxelData& data, std::uint64_t values,
                  std::uint64_t value_size);

/// The same to the last byte: inflates (and drops) compressed data, to its checksum, and counts what is text.
void require_all(const std::string& name, const VoxelData& data, std::uint64_t values,
                 std::uint64_t value_size);

/// Inflates the voxels into `out`, in their own byte order. Throws Error, which begins with `name`, when the
/// stream is damaged or does not hold them all.
void inflate_voxels(const std::string& name, const VoxelData& data, std::span<std::byte> out);

/// The first bytes of a file, at most `size`; of a gzip stream, inflated, if `inflate`.
std::string read_head(const std::filesystem::path& path, std::size_t size, bool inflate = false);

}  // namespace crest
