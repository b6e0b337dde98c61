#pragma once

#include <bit>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// How the arrays of a VTK XML file are written.
struct VtiCoding {
  bool compressed = false;  ///< by zlib, in blocks
  std::endian endian = std::endian::little;
  std::size_t header_bytes = 4;  ///< of each number that says a length
};

/// The bytes of one array, `promised` of them, in the file's byte order. Throws Error, which begins with
/// `name`, when the array has another length or is damaged.
std::vector<std::byte> read_vti_base64(const std::string& name, std::string_view text,
                                       const VtiCoding& coding, std::uint64_t promised);
/// The same from raw bytes in a file.
std::vector<std::byte> read_vti_raw(const std::string& name, const std::filesystem::path& file,
                                    std::uint64_t offset, const VtiCoding& coding, std::uint64_t promised);

/// Where such bytes begin in the file, behind their length, if they are not compressed. Throws as the others.
std::uint64_t find_vti_raw(const std::string& name, const std::filesystem::path& file, std::uint64_t offset,
                           const VtiCoding& coding, std::uint64_t promised);

}  // namespace crest
