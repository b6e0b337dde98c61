#include "render/vdls/homo_regions.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <glm/common.hpp>

#include "render/resources/volume_key.h"

namespace crest {
namespace {

using Region = HomoRegions::Region;

constexpr int levels = 9;  // runs of 1, 2, 4, ... 256 buckets

bool is_empty(const Region& region) { return region.last.x < region.first.x; }

void extend(Region& region, const Region& other) {
  if (is_empty(other)) return;
  region = is_empty(region) ? other
                            : Region{glm::min(region.first, other.first), glm::max(region.last, other.last)};
}

/// Boxes of runs of 2^level buckets from each bucket on. A cell's run of buckets is the union of two such
/// runs, so that it costs two steps, not one a bucket.
struct Runs {
  std::array<std::array<Region, HomoRegions::buckets>, levels> boxes;

  void add(int first, int last, const Region& cell) {
    const int level = std::bit_width(unsigned(last - first + 1)) - 1;
    auto& run = boxes[std::size_t(level)];
    extend(run[std::size_t(first)], cell);
    extend(run[std::size_t(last + 1 - (1 << level))], cell);
  }
  void add(const Runs& other) {
    for (std::size_t level = 0; level < boxes.size(); ++level)
      for (std::size_t i = 0; i < boxes[level].size(); ++i) extend(boxes[level][i], other.boxes[level][i]);
  }
  /// Each bucket's own box: a run passes its box down to its two halves.
  std::array<Region, HomoRegions::buckets> buckets() && {
    for (std::size_t level = levels - 1; level > 0; --level) {
      const std::size_t half = std::size_t(1) << (level - 1);
      for (std::size_t i = 0; i + 2 * half <= HomoRegions::buckets; ++i) {
        extend(boxes[level - 1][i], boxes[level][i]);
        extend(boxes[level - 1][i + half], boxes[level][i]);
      }
    }
    return boxes[0];
  }
};

void add_slice(Runs& runs, const Volume& volume, int k) {
  const glm::ivec3 dims = volume.grid.dims;
  const ValueRange range = volume.statistics.range;
  const double scale = range.width() > 0 ? HomoRegions::buckets / range.width() : 0;
  const auto bucket_of = [&](float value) {
    return std::clamp(int((double(value) - range.min) * scale), 0, HomoRegions::buckets - 1);
  };
  for (int j = 0; j + 1 < dims.y; ++j) {
    const auto column = [&](int i) {  // of the four points at i
      return std::minmax(
          {volume.at(i, j, k), volume.at(i, j + 1, k), volume.at(i, j, k + 1), volume.at(i, j + 1, k + 1)});
    };
    auto left = column(0);
    for (int i = 0; i + 1 < dims.x; ++i) {
      const auto right = column(i + 1);
      const glm::ivec3 cell(i, j, k);
      runs.add(bucket_of(std::min(left.first, right.first)), bucket_of(std::max(left.second, right.second)),
               {cell, cell + 1});
      left = right;
    }
  }
}

struct HomoRegionsKey : VolumeKey {
  using VolumeKey::VolumeKey;
  bool operator==(const HomoRegionsKey&) const = default;
};

}  // namespace

ValueRange HomoRegions::values_of(int bucket) const {
  const double width = range.width() / buckets;
  return {range.min + width * bucket, range.min + width * (bucket + 1)};
}

HomoRegions find_homo_regions(const Volume& volume) {
  const Runs runs = tbb::parallel_reduce(
      tbb::blocked_range<int>(0, volume.grid.dims.z - 1), Runs{},
      [&](const tbb::blocked_range<int>& slices, Runs found) {
        for (int k = slices.begin(); k < slices.end(); ++k) add_slice(found, volume, k);
        return found;
      },
      [](Runs a, const Runs& b) {
        a.add(b);
        return a;
      });
  return {volume.statistics.range, Runs(runs).buckets()};
}

const HomoRegions& homo_regions(KeyedCache& held, const std::shared_ptr<const Volume>& volume) {
  return held.get(HomoRegionsKey(volume), sizeof(HomoRegions), [&] { return find_homo_regions(*volume); });
}

Box visible_box(const HomoRegions& homo, const Grid& grid,
                const std::function<bool(ValueRange values)>& is_visible) {
  Region visible;
  for (int bucket = 0; bucket < HomoRegions::buckets; ++bucket)
    if (is_visible(homo.values_of(bucket))) extend(visible, homo.regions[std::size_t(bucket)]);
  if (is_empty(visible)) return {glm::dvec3(1), glm::dvec3(0)};
  return {grid.origin + grid.spacing * glm::dvec3(visible.first),
          grid.origin + grid.spacing * glm::dvec3(visible.last)};
}

}  // namespace crest
