#include "render/volume/value_counts.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "render/volume/histogram_bins.h"
#include "render/volume/row_scan.h"

namespace crest {
namespace {

/// Calls `visit` with what is stored, where that is integers.
template <class Visit>
void with_integers(const Voxels& values, const Visit& visit) {
  std::visit(
      [&](const auto& stored) {
        using T = typename std::decay_t<decltype(stored)>::value_type;
        if constexpr (std::is_integral_v<T>) visit(stored);
      },
      values.stored());
}

/// Calls visit(value, how often) for those that are there.
template <class Visit>
void for_each_value(const Voxels& values, const ValueCounts& counts, const Visit& visit) {
  with_integers(values, [&](const auto& stored) {
    using T = typename std::decay_t<decltype(stored)>::value_type;
    const LinearMap map = values.map();
    for (std::size_t i = 0; i < counts.size(); ++i)
      if (counts[i] > 0) visit(mapped_to_float(T(int(i) + std::numeric_limits<T>::min()), map), counts[i]);
  });
}

}  // namespace

ValueCounts no_counts(const Voxels& values) {
  ValueCounts counts;
  with_integers(values, [&](const auto& stored) {
    counts.resize(std::size_t(1) << (8 * sizeof(typename std::decay_t<decltype(stored)>::value_type)));
  });
  return counts;
}

void add_counts(const Voxels& values, std::size_t first, std::size_t count, ValueCounts& counts) {
  with_integers(values, [&](const auto& stored) { count_row(stored.data() + first, count, counts.data()); });
}

void add_to(ValueCounts& whole, const ValueCounts& part) {
  for (std::size_t i = 0; i < whole.size(); ++i) whole[i] += part[i];
}

ValueCounts count_values(const Voxels& values) {
  constexpr std::size_t grain = std::size_t(1) << 20;
  tbb::enumerable_thread_specific<ValueCounts> parts([&] { return no_counts(values); });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, values.size(), grain),
                    [&](const auto& part) { add_counts(values, part.begin(), part.size(), parts.local()); });
  ValueCounts whole = no_counts(values);
  for (const ValueCounts& part : parts) add_to(whole, part);
  return whole;
}

void summarize(const Voxels& values, const ValueCounts& counts, VolumeStatistics& statistics) {
  ValueRange range{INFINITY, -INFINITY};
  double sum = 0, squares = 0;
  std::uint64_t finite = 0;
  for_each_value(values, counts, [&](float value, std::uint64_t count) {
    if (!std::isfinite(value)) {
      statistics.inf_count += count;
      return;
    }
    finite += count;
    sum += double(value) * double(count);
    range = joined(range, {double(value), double(value)});
  });
  if (finite == 0) return;
  statistics.range = range;
  statistics.mean = sum / double(finite);
  for_each_value(values, counts, [&](double value, std::uint64_t count) {
    const double beyond = value - statistics.mean;
    if (std::isfinite(value)) squares += beyond * beyond * double(count);
  });
  statistics.variance = squares / double(finite);
}

std::vector<std::uint64_t> histogram_of(const Voxels& values, const ValueCounts& counts, ValueRange range,
                                        int bins) {
  const HistogramBins bin_of(range, bins);
  std::vector<std::uint64_t> histogram(bin_of.size());
  for_each_value(values, counts, [&](double value, std::uint64_t count) {
    if (bin_of.has(value)) histogram[bin_of(value)] += count;
  });
  return histogram;
}

}  // namespace crest
