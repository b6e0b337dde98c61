#include "render/classify/peak_table.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <string>

#include "presets/error.h"

namespace crest {
namespace {

/// The bins that a field value equal to a peak may fall into, whatever order and precision the arithmetic of
/// PeakTable::bin_of has.
struct BinInterval {
  int low = 0, high = 0;
};

BinInterval bins_at(const PeakTable& table, double value) {
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

int PeakTable::largest_count() const {
  int largest = 0;
  for (const Cell& cell : cells) largest = std::max(largest, int(cell.count));
  return largest;
}

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
  constexpr std::size_t most_peaks = std::numeric_limits<std::uint16_t>::max();
  if (peaks.size() > most_peaks)
    throw Error("the peak table holds at most " + std::to_string(most_peaks) + " peaks, not " +
                std::to_string(peaks.size()));
  if (bins < 1 || bins > largest_bins)
    throw Error("the peak table has 1 to " + std::to_string(largest_bins) + " bins, not " +
                std::to_string(bins));

  PeakTable table{.bins = bins, .range = range, .cells = {}};

  // begin[b]: the first peak that may be at or above bin b. end[b]: one past the last that may be at or
  // below it. What a segment between bins a <= b may cross is then peaks begin[a] up to end[b].
  const std::size_t size = std::size_t(bins);
  const auto before = [](double limit) {
    return [limit](const Peak& p) { return float(p.value) < float(limit); };
  };
  const auto up_to = [](double limit) {
    return [limit](const Peak& p) { return float(p.value) <= float(limit); };
  };
  const auto inside = std::partition_point(peaks.begin(), peaks.end(), before(range.min));
  const auto beyond = std::partition_point(inside, peaks.end(), up_to(range.max));
  const int first_inside = int(inside - peaks.begin()), past_inside = int(beyond - peaks.begin());
  std::vector<int> begin(size, past_inside), end(size, first_inside);
  int from = 0;
  for (int i = first_inside; i < past_inside; ++i) {
    const BinInterval at = bins_at(table, peaks[std::size_t(i)].value);
    for (; from <= at.high; ++from) begin[std::size_t(from)] = i;
    end[std::size_t(at.low)] = i + 1;
  }
  for (std::size_t b = 1; b < size; ++b) end[b] = std::max(end[b], end[b - 1]);

  table.cells.resize(size * size);
  for (std::size_t exit = 0; exit < size; ++exit) {
    for (std::size_t entry = 0; entry < size; ++entry) {
      const int first = begin[std::min(entry, exit)], past = end[std::max(entry, exit)];
      if (past > first)
        table.cells[exit * size + entry] = {std::uint16_t(first), std::uint16_t(past - first)};
    }
  }
  return table;
}

std::array<int, peaks_per_cell> peaks_met(const PeakTable& table, int entry_bin, int exit_bin) {
  const PeakTable::Cell cell = table.cell(entry_bin, exit_bin);
  std::array<int, peaks_per_cell> met;
  met.fill(-1);
  const int listed = std::min(int(cell.count), peaks_per_cell);
  for (int i = 0; i < listed; ++i)
    met[std::size_t(i)] = entry_bin <= exit_bin ? cell.first + i : cell.first + cell.count - 1 - i;
  return met;
}

}  // namespace crest
