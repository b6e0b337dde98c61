#include "render/readers/vti_pieces.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>

#include "presets/error.h"

namespace crest {

VtiExtent joined(const std::vector<VtiExtent>& pieces) {
  VtiExtent whole = pieces.front();
  for (const VtiExtent& piece : pieces) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      whole[2 * axis] = std::min(whole[2 * axis], piece[2 * axis]);
      whole[2 * axis + 1] = std::max(whole[2 * axis + 1], piece[2 * axis + 1]);
    }
  }
  return whole;
}

VtiGrid::VtiGrid(glm::u64vec3 dims, std::size_t point_bytes)
    : dims_(dims),
      point_bytes_(point_bytes),
      bytes_(dims.x * dims.y * dims.z * point_bytes),
      is_there_(dims.x * dims.y * dims.z) {}

void VtiGrid::put(std::span<const std::byte> piece, glm::u64vec3 first, glm::u64vec3 dims) {
  for (std::uint64_t row = 0; row < dims.y * dims.z; ++row) {
    const std::uint64_t y = first.y + row % dims.y, z = first.z + row / dims.y;
    const std::uint64_t to = first.x + dims_.x * (y + dims_.y * z);
    std::memcpy(bytes_.data() + to * point_bytes_, piece.data() + row * dims.x * point_bytes_,
                dims.x * point_bytes_);
    std::fill_n(is_there_.begin() + std::ptrdiff_t(to), dims.x, true);
  }
}

std::vector<std::byte> VtiGrid::take(const std::string& name) {
  if (const auto missing = std::ranges::count(is_there_, false); missing > 0) {
    throw Error(
        fmt::format("{}: its pieces leave {} of {} points without a value", name, missing, is_there_.size()));
  }
  return std::move(bytes_);
}

}  // namespace crest
