#include "ui/histogram_cache.h"

#include <algorithm>
#include <cmath>

namespace crest {
namespace {

/// Zoomed out this far, the volume's own bins are fine enough.
constexpr double wide_share = 0.2;

std::vector<std::uint64_t> grouped(const std::vector<std::uint64_t>& bins) {
  const std::size_t group = std::max<std::size_t>(1, bins.size() / std::size_t(histogram_columns));
  std::vector<std::uint64_t> counts((bins.size() + group - 1) / group);
  for (std::size_t i = 0; i < bins.size(); ++i) counts[i / group] += bins[i];
  return counts;
}

bool is_drawable(ValueRange range) {
  return std::isfinite(range.min) && std::isfinite(range.max) && range.max > range.min;
}

}  // namespace

void update_histogram(HistogramCache& cache, const Volume& volume, ValueRange visible) {
  const ValueRange whole = volume.statistics.range;
  const ValueRange wanted{std::max(visible.min, whole.min), std::min(visible.max, whole.max)};
  const bool at_rest = wanted == cache.wanted;
  cache.wanted = wanted;
  if (cache.source != volume.values.data()) {
    cache = HistogramCache{};
    cache.source = volume.values.data();
    cache.wanted = wanted;
  }
  const bool wide = !is_drawable(wanted) || wanted.width() > wide_share * whole.width();
  const ValueRange target = wide ? whole : wanted;
  if (cache.range == target && !cache.counts.empty()) return;
  if (!wide && !at_rest && !cache.counts.empty()) return;
  cache.range = target;
  cache.counts =
      wide ? grouped(volume.statistics.histogram) : histogram_of(volume.values, target, histogram_columns);
  cache.largest = 0;
  for (const std::uint64_t count : cache.counts) cache.largest = std::max(cache.largest, count);
}

}  // namespace crest
