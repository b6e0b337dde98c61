#pragma once

#include <vector>

#include "render/classify/peak_table.h"

namespace crest {

/// A rectangle of a peak table's cells whose segments meet the same peak first. Both bins of a pair are in
/// it.
struct TableRegion {
  int first_entry = 0, last_entry = 0;
  int first_exit = 0, last_exit = 0;
  int peak = 0;  ///< its index among the table's

  bool operator==(const TableRegion&) const = default;
};

/// The table as a picture: regions that do not overlap and hold every cell that has a candidate. Which peak
/// is met first depends on the entry alone, and the exit tells whether it is met. So a peak has a region
/// above the diagonal and one below it, and the cells in its own column; there are more where rounding may
/// put it in several bins. O(bins).
std::vector<TableRegion> table_regions(const PeakTable& table);

}  // namespace crest
