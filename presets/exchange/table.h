#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

inline constexpr int most_table_rows = 1 << 20;
/// The most that fewest_rows() returns: the widest texture that any graphics card takes.
inline constexpr int most_automatic_rows = 16384;

/// A TF as equidistant rows, which a reader interpolates linearly, and what that loses.
struct TfTable1d {
  ValueRange range;              ///< the values of the first row and of the last
  std::vector<glm::dvec4> rows;  ///< colour (not premultiplied) and opacity; at least 2
  int widened = 0;               ///< peaks that lie between rows, and were put on the nearest one
  int lost = 0;                  ///< peaks that share their row with a higher one
  double largest_error = 0;  ///< of opacity or a visible colour at the control points, after interpolation
  double at_value = 0;       ///< where that is

  double spacing() const { return range.width() / double(rows.size() - 1); }
  double value(std::size_t row) const;
};

/// A row is the TF at its value, but for peaks - points whose opacity is higher than both their neighbours' -
/// that lie between rows: each is put on its nearest row, so that it keeps its height. `range` has a width,
/// `count` is in 2..most_table_rows. The error at a peak is that of its row, and at a point too near to
/// another one for any table (of most_automatic_rows; points of a step are) that of the best row within one
/// and a half of it.
TfTable1d make_table(const TransferFunction& tf, ValueRange range, int count);

/// The fewest rows that hold all control points to 1/255, and no two peaks in one; most_automatic_rows where
/// none do.
int fewest_rows(const TransferFunction& tf, ValueRange range);

}  // namespace crest
