#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "render/volume/differences.h"
#include "render/volume/plateaus.h"
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

}  // namespace

VolumeStatistics compute_statistics(const Grid& grid, const Voxels& values, int bins) {
  const std::size_t chunks = (values.size() + chunk_size - 1) / chunk_size;
  std::vector<Moments> parts(chunks);
  tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t c) {
    const std::size_t begin = c * chunk_size;
    std::vector<float> room;
    parts[c] = moments_of(values.part(begin, std::min(chunk_size, values.size() - begin), room));
  });
  Moments all;
  for (const Moments& part : parts) all = join(all, part);

  VolumeStatistics statistics;
  statistics.nan_count = all.nan;
  statistics.inf_count = all.inf;
  if (all.finite > 0) {
    statistics.range = {all.min, all.max};
    statistics.mean = all.mean;
    statistics.variance = all.squares / double(all.finite);
  }
  statistics.largest_difference = largest_differences(grid, values);
  if (all.nan + all.inf > 0) {
    const PointBox empty = empty_part(grid, values);
    statistics.empty_min = empty.min;
    statistics.empty_max = empty.max;
  }
  statistics.plateaus = find_plateaus(grid, values);
  statistics.histogram = histogram_of(values, statistics.range, bins);
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

std::vector<std::uint64_t> histogram_of(const Voxels& values, ValueRange range, int bins) {
  using Counts = std::vector<std::uint64_t>;
  const std::size_t size = std::size_t(std::max(bins, 1));
  const double scale = range.width() > 0 ? double(size) / range.width() : 0;
  tbb::enumerable_thread_specific<Counts> counts(Counts(size, 0));
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, values.size(), chunk_size), [&](const auto& part) {
    Counts& mine = counts.local();
    std::vector<float> room;
    for (const double v : values.part(part.begin(), part.size(), room)) {
      if (!std::isfinite(v) || v < range.min || v > range.max) continue;
      ++mine[std::min(std::size_t((v - range.min) * scale), size - 1)];
    }
  });
  Counts total(size, 0);
  for (const Counts& part : counts) {
    for (std::size_t i = 0; i < size; ++i) total[i] += part[i];
  }
  return total;
}

}  // namespace crest
