#include "render/files/read_slabs.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <vector>

#include "render/volume/voxel_store.h"

namespace crest {
namespace {

/// Points [begin, end) on each axis.
struct Box {
  glm::u64vec3 begin{0}, end{0};
  glm::u64vec3 size() const { return end - begin; }
};

/// Stored values from the first to the last of a box's points.
std::uint64_t extent_of(const VoxelLayout& layout, const Box& box) {
  return layout.place(box.end - glm::u64vec3(1)) - layout.place(box.begin) + 1;
}

/// How many of `count` layers become a slab, where each takes `layer` values and begins `apart` after the
/// one before. Large layers with more than their size between them are read alone: a file is skipped over.
std::uint64_t layers_at_once(std::uint64_t count, std::uint64_t layer, std::uint64_t apart,
                             std::uint64_t most) {
  constexpr std::uint64_t worth_a_seek = 1 << 16;
  if (layer >= most || (layer >= worth_a_seek && apart / 2 >= layer)) return 1;
  return std::min(count, 1 + (most - layer) / apart);
}

/// Calls `visit` with boxes that together are `box`, in the order of the file, each of `most` values or of
/// one point.
template <class Visit>
void for_each_slab(const VoxelLayout& layout, const std::array<int, 3>& slow_to_fast, Box box,
                   std::uint64_t most, const Visit& visit) {
  const auto slowest = std::ranges::find_if(slow_to_fast, [&](int axis) { return box.size()[axis] > 1; });
  if (slowest == slow_to_fast.end() || extent_of(layout, box) <= most) return visit(box);
  const int axis = *slowest;
  Box layer = box;
  layer.end[axis] = box.begin[axis] + 1;
  const std::uint64_t step =
      layers_at_once(box.size()[axis], extent_of(layout, layer), layout.stride[axis], most);
  for (std::uint64_t begin = box.begin[axis]; begin < box.end[axis]; begin += step) {
    Box part = box;
    part.begin[axis] = begin;
    part.end[axis] = std::min(begin + step, box.end[axis]);
    for_each_slab(layout, slow_to_fast, part, step == 1 ? most : extent_of(layout, part), visit);
  }
}

/// Takes a slab's rows; what is lost of them.
Rounding put_slab(const VoxelLayout& layout, const Box& box, const StoredAs& stored,
                  std::span<const std::byte> bytes, VoxelStore& store) {
  const glm::u64vec3 size = box.size();
  const std::uint64_t begin = layout.place(box.begin);
  const bool rounds = may_round(stored.type, stored.map);
  return tbb::parallel_reduce(
      tbb::blocked_range<std::uint64_t>(0, size.y * size.z), Rounding(),
      [&](const auto& rows, Rounding lost) {
        for (std::uint64_t row = rows.begin(); row != rows.end(); ++row) {
          const glm::u64vec3 point = box.begin + glm::u64vec3(0, row % size.y, row / size.y);
          const auto at = bytes.subspan((layout.place(point) - begin) * size_of(stored.type));
          store.put(point.x + layout.dims.x * (point.y + layout.dims.y * point.z), size.x, at, stored.type,
                    layout.stride.x, stored.map);
          if (rounds) lost = joined(lost, rounding_of(at, stored.type, size.x, layout.stride.x, stored.map));
        }
        return lost;
      },
      [](const Rounding& a, const Rounding& b) { return joined(a, b); });
}

}  // namespace

SlabsRead read_slabs(const VoxelLayout& layout, const StoredAs& stored, const ReadValues& read,
                     const TellShare& progress) {
  const std::size_t value_size = size_of(stored.type);
  VoxelStore store(stored.type, layout.dims.x * layout.dims.y * layout.dims.z, stored.map);
  std::array slow_to_fast{2, 1, 0};
  std::ranges::stable_sort(slow_to_fast, std::greater(), [&](int axis) { return layout.stride[axis]; });
  SlabsRead result;
  std::vector<std::byte> bytes;
  const double values = double(layout.dims.x) * double(layout.dims.y) * double(layout.dims.z);
  std::uint64_t done = 0;
  for_each_slab(layout, slow_to_fast, {glm::u64vec3(0), layout.dims}, slab_bytes / value_size,
                [&](const Box& box) {
                  bytes.resize(extent_of(layout, box) * value_size);
                  read(layout.place(box.begin), bytes);
                  if (stored.endian != std::endian::native) swap_bytes(bytes, value_size);
                  result.rounding = joined(result.rounding, put_slab(layout, box, stored, bytes, store));
                  done += box.size().x * box.size().y * box.size().z;
                  tell(progress, double(done) / values);
                });
  result.values = store.take();
  return result;
}

}  // namespace crest
