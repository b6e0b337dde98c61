#include "render/readers/vti_pieces.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/error.h"

namespace crest {

VtiExtent joined(const VtiExtent& a, const VtiExtent& b) {
  VtiExtent both;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    both[2 * axis] = std::min(a[2 * axis], b[2 * axis]);
    both[2 * axis + 1] = std::max(a[2 * axis + 1], b[2 * axis + 1]);
  }
  return both;
}

glm::u64vec3 dims_of(const VtiExtent& extent, bool of_cells) {
  glm::u64vec3 dims;
  for (std::size_t axis = 0; axis < 3; ++axis)
    dims[int(axis)] = std::uint64_t(extent[2 * axis + 1] - extent[2 * axis]) + (of_cells ? 0 : 1);
  return dims;
}

glm::u64vec3 place_of(const VtiExtent& piece, const VtiExtent& grid) {
  return {std::uint64_t(piece[0] - grid[0]), std::uint64_t(piece[2] - grid[2]),
          std::uint64_t(piece[4] - grid[4])};
}

VtiGrid::VtiGrid(std::string name, glm::u64vec3 dims, std::size_t point_bytes, std::vector<VtiPart> parts)
    : name_(std::move(name)), dims_(dims), point_bytes_(point_bytes), parts_(std::move(parts)) {
  std::erase_if(parts_,
                [](const VtiPart& part) { return part.dims.x == 0 || part.dims.y == 0 || part.dims.z == 0; });
}

void VtiGrid::read(std::uint64_t first, std::span<std::byte> out) {
  is_there_.assign(out.size(), 0);
  const auto place = [&](glm::u64vec3 p) { return point_bytes_ * (p.x + dims_.x * (p.y + dims_.y * p.z)); };
  for (VtiPart& part : parts_) {
    const std::uint64_t begin = place(part.first),
                        end = place(part.first + part.dims - glm::u64vec3(1)) + point_bytes_;
    if (end <= first) close(part);
    if (begin >= first + out.size() || end <= first) continue;
    if (!part.source.values) part.source = part.open();
    take(part, first, out);
  }
  const auto gap = std::ranges::find(is_there_, 0);
  if (gap == is_there_.end()) return;
  const std::uint64_t point = (first + std::uint64_t(gap - is_there_.begin())) / point_bytes_;
  throw Error(fmt::format("{}: its pieces leave points without a value: the first is ({}, {}, {})", name_,
                          point % dims_.x, point / dims_.x % dims_.y, point / dims_.x / dims_.y));
}

/// What a piece has of the bytes from `first` on: of each of its rows a part.
void VtiGrid::take(VtiPart& part, std::uint64_t first, std::span<std::byte> out) {
  const VtiSource& source = part.source;
  const std::uint64_t layer = point_bytes_ * dims_.x * dims_.y, last = first + out.size() - 1;
  const std::uint64_t z_begin = std::max(part.first.z, first / layer),
                      z_end = std::min(part.first.z + part.dims.z, last / layer + 1);
  for (std::uint64_t z = z_begin; z < z_end; ++z) {
    for (std::uint64_t y = 0; y < part.dims.y; ++y) {
      const std::uint64_t row = point_bytes_ * (part.first.x + dims_.x * (part.first.y + y + dims_.y * z));
      const std::uint64_t from = std::max(row, first),
                          to = std::min(row + point_bytes_ * part.dims.x, first + out.size());
      if (from >= to) continue;
      const glm::u64vec3 in_source = source.first + glm::u64vec3(0, y, z - part.first.z);
      const std::uint64_t begin =
          point_bytes_ * (in_source.x + source.dims.x * (in_source.y + source.dims.y * in_source.z));
      source.values->read(begin + (from - row), out.subspan(from - first, to - from));
      std::fill_n(is_there_.begin() + std::ptrdiff_t(from - first), to - from, std::uint8_t(1));
    }
  }
}

bool VtiGrid::finish() {
  std::ranges::for_each(parts_, close);
  return false;
}

void VtiGrid::close(VtiPart& part) {
  if (part.source.values) part.source.values->finish();
  part.source.values.reset();
}

}  // namespace crest
