#include "render/classify/peak_table.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "presets/error.h"

namespace crest {
namespace {

/// The bins that a field value equal to a peak may fall into, whatever order and precision the arithmetic of
/// PeakTable::bin_of has.
struct BinRange {
  int low = 0, high = 0;
};

BinRange bins_at(const PeakTable& table, double value) {
  const double v = float(value), min = float(table.range.min), scale = table.bin_scale();
  const double position = (v - min) * scale;
  // Each of the terms and the product rounds to 2^-24 at most, and FLT_MIN is what flushing may take; twice
  // that, for good measure.
  const double slack = 0x1p-23 * ((std::abs(v) + std::abs(min)) * scale + 3 * std::abs(position)) +
                       2 * double(FLT_MIN) * scale;
  const auto bin = [&](double x) { return int(std::clamp(std::floor(x), 0.0, double(table.bins - 1))); };
  return {bin(position - slack), bin(position + slack)};
}

}  // namespace

float PeakTable::bin_scale() const {
  const double width = range.width() > 0 ? range.width() : 1;
  return float(std::min(bins / width, 1e38));
}

int PeakTable::bin_of(double value) const {
  const float position = (float(value) - float(range.min)) * bin_scale();
  return position > 0 ? int(std::min(position, float(bins - 1))) : 0;
}

PeakTable::Cell PeakTable::cell(int entry_bin, int exit_bin) const {
  const auto [least, greatest] = std::minmax(entry_bin, exit_bin);
  const int first = first_peak_from[std::size_t(least)], past = past_peak_to[std::size_t(greatest)];
  return past > first ? Cell{first, past - first} : Cell{};
}

int PeakTable::largest_count() const { return cell(0, bins - 1).count; }

double smallest_gap(std::span<const Peak> peaks) {
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < peaks.size(); ++i)
    gap = std::min(gap, double(float(peaks[i].value)) - double(float(peaks[i - 1].value)));
  return gap;
}

int separating_bins(std::span<const Peak> peaks, ValueRange range, int most) {
  double gap = std::numeric_limits<double>::infinity();  // of those that bins can separate
  for (std::size_t i = 1; i < peaks.size(); ++i) {
    const double here = smallest_gap(peaks.subspan(i - 1, 2));
    if (here > 0) gap = std::min(gap, here);
  }
  const double bins = std::ceil(4 * range.width() / gap);
  return bins < most ? std::max(int(bins), 1) : most;
}

PeakTable build_peak_table(std::span<const Peak> peaks, ValueRange range, int bins) {
  if (peaks.size() > std::size_t(most_table_peaks))
    throw Error("the peak table holds at most " + std::to_string(most_table_peaks) + " peaks, not " +
                std::to_string(peaks.size()));
  if (bins < 1 || bins > largest_bins)
    throw Error("the peak table has 1 to " + std::to_string(largest_bins) + " bins, not " +
                std::to_string(bins));

  // Peaks outside the range are in no run: they begin at the first inside, and end before the first beyond
  const auto before = [](double limit) {
    return [limit](const Peak& p) { return float(p.value) < float(limit); };
  };
  const auto up_to = [](double limit) {
    return [limit](const Peak& p) { return float(p.value) <= float(limit); };
  };
  const auto inside = std::partition_point(peaks.begin(), peaks.end(), before(range.min));
  const auto beyond = std::partition_point(inside, peaks.end(), up_to(range.max));
  const int first_inside = int(inside - peaks.begin()), past_inside = int(beyond - peaks.begin());
  PeakTable table{.bins = bins,
                  .range = range,
                  .first_peak_from = std::vector<int>(std::size_t(bins), past_inside),
                  .past_peak_to = std::vector<int>(std::size_t(bins), first_inside)};
  int from = 0;
  for (int i = first_inside; i < past_inside; ++i) {
    const BinRange at = bins_at(table, peaks[std::size_t(i)].value);
    for (; from <= at.high; ++from) table.first_peak_from[std::size_t(from)] = i;
    table.past_peak_to[std::size_t(at.low)] = i + 1;
  }
  std::inclusive_scan(table.past_peak_to.begin(), table.past_peak_to.end(), table.past_peak_to.begin(),
                      [](int a, int b) { return std::max(a, b); });
  return table;
}

std::array<int, peaks_per_cell> peaks_met(const PeakTable& table, int entry_bin, int exit_bin) {
  const PeakTable::Cell cell = table.cell(entry_bin, exit_bin);
  std::array<int, peaks_per_cell> met;
  met.fill(-1);
  const int listed = std::min(cell.count, peaks_per_cell);
  for (int i = 0; i < listed; ++i)
    met[std::size_t(i)] = entry_bin <= exit_bin ? cell.first + i : cell.first + cell.count - 1 - i;
  return met;
}

}  // namespace crest
