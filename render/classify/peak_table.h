#pragma once

#include <array>
#include <span>
#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"

namespace crest {

/// The peak lookup table (Knoll et al. 2009, section 4.1): for a segment that enters at one value and exits
/// at another, the peaks that it may cross. Peaks are sorted by value, so the candidates of a cell are a run
/// of them, met first to last when the value rises and last to first when it falls. A run has any length:
/// none is lost. Where it begins follows from the lesser of the two values, where it ends from the greater:
/// two arrays over the bins are the whole table, and its cells are read off them.
struct PeakTable {
  /// A run of peaks that a cell's segments may cross; count 0 is the flag value "no peak".
  struct Cell {
    int first = 0, count = 0;
    bool operator==(const Cell&) const = default;
  };
  int bins = 0;                      ///< of the two arrays, at least 1
  ValueRange range;                  ///< of the field; values beyond count to the end bins
  std::vector<int> first_peak_from;  ///< by bin: the first peak that may be in it or above
  std::vector<int> past_peak_to;     ///< by bin: one past the last peak that may be in it or below

  Cell cell(int entry_bin, int exit_bin) const;
  /// The bin of a field value, in float32 as the shader reckons it:
  /// clamp(int((value - float(range.min)) * bin_scale()), 0, bins - 1).
  int bin_of(double value) const;
  /// float(bins / width): finite, also for a range of no width, which counts as 1.
  float bin_scale() const;
  int largest_count() const;  ///< candidates in the fullest cell
};

/// Most peaks that are listed for one cell.
inline constexpr int peaks_per_cell = 4;

/// Most bins on an axis.
inline constexpr int largest_bins = 4096;

/// Most peaks in a table.
inline constexpr int most_table_peaks = 65535;

/// So many bins that two peaks, unless they have the same float32 value, are at least four bins apart: then
/// few segments have a candidate that they do not cross. At most `most`.
int separating_bins(std::span<const Peak> peaks, ValueRange range, int most);

/// The least distance of two neighbouring peaks' float32 values: infinity for fewer than two peaks.
double smallest_gap(std::span<const Peak> peaks);

/// Builds the table in O(bins + peaks). `peaks` are the shown ones, by ascending value. Cells of equal bins
/// count their peaks too. A peak is in the cell of every two float32 field values with its own float32 value
/// between or at them, however the shader's arithmetic rounds. No field value lies outside `range`, so peaks
/// that do are in no cell. Throws Error for more than most_table_peaks, or bins outside 1..largest_bins.
PeakTable build_peak_table(std::span<const Peak> peaks, ValueRange range, int bins);

/// The peaks of a cell, as indices in the order in which they are met: at most `peaks_per_cell`, then -1, the
/// flag. Ascending also where the bins are equal: there the shader knows the order by the values' own.
std::array<int, peaks_per_cell> peaks_met(const PeakTable& table, int entry_bin, int exit_bin);

}  // namespace crest
