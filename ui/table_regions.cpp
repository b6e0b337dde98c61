#include "ui/table_regions.h"

#include <algorithm>

namespace crest {
namespace {

/// Appends a column's part to the regions, joined with that of the column before it where they are alike.
void add_column(std::vector<TableRegion>& regions, const TableRegion& column) {
  if (column.first_exit > column.last_exit) return;
  if (!regions.empty()) {
    TableRegion& left = regions.back();
    if (left.last_entry + 1 == column.first_entry && left.first_exit == column.first_exit &&
        left.last_exit == column.last_exit && left.peak == column.peak) {
      left.last_entry = column.last_entry;
      return;
    }
  }
  regions.push_back(column);
}

}  // namespace

std::vector<TableRegion> table_regions(const PeakTable& table) {
  std::vector<TableRegion> rising, falling;
  int rising_exit = 0, falling_exit = 0;  // the first exit, and one past the last, that have a candidate
  for (int entry = 0; entry < table.bins; ++entry) {
    const int first = table.first_peak_from[std::size_t(entry)];
    while (rising_exit < table.bins && table.past_peak_to[std::size_t(rising_exit)] <= first) ++rising_exit;
    add_column(rising, {entry, entry, std::max(rising_exit, entry), table.bins - 1, first});
    const int past = table.past_peak_to[std::size_t(entry)];
    while (falling_exit < table.bins && table.first_peak_from[std::size_t(falling_exit)] < past)
      ++falling_exit;
    add_column(falling, {entry, entry, 0, std::min(falling_exit, entry) - 1, past - 1});
  }
  rising.insert(rising.end(), falling.begin(), falling.end());
  return rising;
}

}  // namespace crest
