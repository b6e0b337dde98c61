#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <vector>

#include "presets/transfer_function.h"
#include "render/files/raw_layout.h"

namespace crest {

/// A slice of raw voxels as grey values, row 0 (the least y) at the top.
struct RawSlice {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> grey;  ///< over `range`; 0 where there is no finite value
  std::vector<bool> is_there;      ///< false beyond the file's end
  ValueRange range{0, 0};          ///< of the finite values that were read
};

/// The middle slice across z, of which no more than `most` columns and rows are kept, evenly spread. Nothing
/// else of the file is read, and where it ends within the slice the rest is not there. Throws Error where a
/// row is too long for a preview or the file cannot be read.
RawSlice read_middle_slice(const std::filesystem::path& path, const RawLayout& layout, int most);

}  // namespace crest
