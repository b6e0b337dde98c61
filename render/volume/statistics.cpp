#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "render/volume/histogram_bins.h"
#include "render/volume/neighbours.h"
#include "render/volume/value_counts.h"
#include "render/volume/volume.h"

namespace crest {
namespace {

/// Values are summed in chunks of this many, and the chunks in order: the result does not depend on how many
/// threads there are.
constexpr std::size_t chunk_size = std::size_t(1) << 16;

/// Count, mean and sum of squared deviations of the finite values, which two parts can be joined by.
struct Moments {
  std::uint64_t finite = 0, nan = 0, inf = 0;
  double mean = 0, squares = 0;
  float min = INFINITY, max = -INFINITY;
};

Moments moments_of(std::span<const float> values) {
  Moments m;
  double sum = 0;
  for (const float v : values) {
    if (std::isnan(v)) {
      ++m.nan;
    } else if (std::isinf(v)) {
      ++m.inf;
    } else {
      ++m.finite;
      sum += v;
      m.min = std::min(m.min, v);
      m.max = std::max(m.max, v);
    }
  }
  if (m.finite == 0) return m;
  m.mean = sum / double(m.finite);
  for (const float v : values) {
    if (std::isfinite(v)) m.squares += (v - m.mean) * (v - m.mean);
  }
  return m;
}

/// Chan, Golub and LeVeque's update for two sets.
Moments join(const Moments& a, const Moments& b) {
  Moments m;
  m.finite = a.finite + b.finite;
  m.nan = a.nan + b.nan;
  m.inf = a.inf + b.inf;
  m.min = std::min(a.min, b.min);
  m.max = std::max(a.max, b.max);
  if (m.finite == 0) return m;
  const double share = double(b.finite) / double(m.finite), delta = b.mean - a.mean;
  m.mean = a.mean + delta * share;
  m.squares = a.squares + b.squares + delta * delta * share * double(a.finite);
  return m;
}

/// What is found by going through all voxels once, slice by slice.
class Pass {
 public:
  Pass(const Grid& grid, const Voxels& values)
      : grid_(grid),
        values_(values),
        slice_(std::size_t(grid.dims.x) * std::size_t(grid.dims.y)),
        neighbours_([&] { return Neighbours(grid); }),
        counts_([&] { return no_counts(values); }),
        moments_(values.are_floats() ? (values.size() + chunk_size - 1) / chunk_size : 0) {}

  /// Slices [begin, end). Any thread may, for other slices.
  void add(int begin, int end) {
    add_neighbours(grid_, values_, begin, end, neighbours_.local());
    const std::size_t first = slice_ * std::size_t(begin), last = slice_ * std::size_t(end);
    if (!values_.are_floats()) return add_counts(values_, first, last - first, counts_.local());
    std::vector<float> room;
    for (std::size_t c = (first + chunk_size - 1) / chunk_size; c * chunk_size < last; ++c) {
      const std::size_t at = c * chunk_size;
      moments_[c] = moments_of(values_.part(at, std::min(chunk_size, values_.size() - at), room));
    }
  }

  VolumeStatistics finish(int bins) const {
    VolumeStatistics statistics;
    if (values_.are_floats()) {
      summarize(statistics);
      statistics.histogram = histogram_of(values_, statistics.range, bins);
    } else {
      ValueCounts counts = no_counts(values_);
      for (const ValueCounts& part : counts_) add_to(counts, part);
      crest::summarize(values_, counts, statistics);
      statistics.histogram = histogram_of(values_, counts, statistics.range, bins);
    }
    Neighbours found(grid_);
    for (const Neighbours& part : neighbours_) found.join(part);
    statistics.largest_difference = found.largest_difference;
    statistics.plateaus = plateaus_of(grid_, found);
    if (found.high.x >= 0) {  // the cells around a point reach to its neighbours
      statistics.empty_min = glm::max(found.low - 1, glm::ivec3(0));
      statistics.empty_max = glm::min(found.high + 1, grid_.dims - 1);
    }
    return statistics;
  }

 private:
  void summarize(VolumeStatistics& statistics) const {
    Moments all;
    for (const Moments& part : moments_) all = join(all, part);
    statistics.nan_count = all.nan;
    statistics.inf_count = all.inf;
    if (all.finite == 0) return;
    statistics.range = {all.min, all.max};
    statistics.mean = all.mean;
    statistics.variance = all.squares / double(all.finite);
  }

  const Grid& grid_;
  const Voxels& values_;
  std::size_t slice_;
  tbb::enumerable_thread_specific<Neighbours> neighbours_;
  tbb::enumerable_thread_specific<ValueCounts> counts_;
  std::vector<Moments> moments_;  ///< of floats, a chunk each
};

}  // namespace

VolumeStatistics compute_statistics(const Grid& grid, const Voxels& values, int bins,
                                    const TellShare& progress) {
  // Progress is told by this thread, after each batch of so many voxels, or of some slices for each thread.
  constexpr std::size_t batch = std::size_t(1) << 25;
  const int threads = tbb::this_task_arena::max_concurrency();
  const int grain = std::clamp(grid.dims.z / (4 * threads), 1, 4);  // slices: the last one is mapped twice
  const std::size_t slice = std::size_t(grid.dims.x) * std::size_t(grid.dims.y);
  const int slices = std::max(int(std::min(batch / slice, std::size_t(grid.dims.z))), 4 * grain * threads);
  const double pass_share = values.are_floats() ? 0.8 : 1;  // a histogram of floats comes after it
  Pass pass(grid, values);
  for (int begin = 0; begin < grid.dims.z; begin += slices) {
    const int end = std::min(begin + slices, grid.dims.z);
    tbb::parallel_for(tbb::blocked_range<int>(begin, end, grain),
                      [&](const auto& part) { pass.add(part.begin(), part.end()); });
    tell(progress, pass_share * double(end) / double(grid.dims.z));
  }
  VolumeStatistics statistics = pass.finish(bins);
  tell(progress, 1);
  return statistics;
}

std::optional<ValueRange> finite_range(const Volume& volume) {
  const VolumeStatistics& statistics = volume.statistics;
  if (statistics.nan_count + statistics.inf_count >= volume.values.size()) return std::nullopt;
  return statistics.range;
}

ValueRange joined(ValueRange a, ValueRange b) { return {std::min(a.min, b.min), std::max(a.max, b.max)}; }

void widen_range(Volume& volume, ValueRange range) {
  VolumeStatistics& statistics = volume.statistics;
  const std::optional<ValueRange> own = finite_range(volume);
  const ValueRange wide = own ? joined(*own, range) : range;
  if (wide == statistics.range) return;
  statistics.range = wide;
  statistics.histogram = histogram_of(volume.values, wide, int(statistics.histogram.size()));
}

double largest_gradient(const Grid& grid, const VolumeStatistics& statistics) {
  return glm::length(statistics.largest_difference / grid.spacing);
}

std::vector<std::uint64_t> histogram_of(const Voxels& values, ValueRange range, int bins) {
  if (!values.are_floats()) return histogram_of(values, count_values(values), range, bins);
  const HistogramBins bin_of(range, bins);
  tbb::enumerable_thread_specific<ValueCounts> counts(ValueCounts(bin_of.size(), 0));
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, values.size(), chunk_size), [&](const auto& part) {
    ValueCounts& mine = counts.local();
    std::vector<float> room;
    for (const double v : values.part(part.begin(), part.size(), room))
      if (bin_of.has(v)) ++mine[bin_of(v)];
  });
  ValueCounts total(bin_of.size(), 0);
  for (const ValueCounts& part : counts) add_to(total, part);
  return total;
}

}  // namespace crest
