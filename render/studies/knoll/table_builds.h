#pragma once

#include <span>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// What it takes on the CPU to build the tables of two field values for one TF, at the same resolution: the
/// medians of several builds, turn by turn.
struct TableBuild {
  int bins = 0;  ///< on each axis
  double peak_ms = 0, preintegration_ms = 0;

  double ratio() const { return preintegration_ms / peak_ms; }
};

/// `tf` is resolved; peaks are found anew in each build of theirs, since an edit brings that, too.
std::vector<TableBuild> time_table_builds(const TransferFunction& tf, ValueRange field,
                                          double smallest_spacing, std::span<const int> bins);

}  // namespace crest
