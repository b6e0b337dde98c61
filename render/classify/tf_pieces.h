#pragma once

#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// Where a TF is linear, within a field's range: what it is at both ends, seen from between them.
struct TfPiece {
  double from, to;
  Classified begin, end;
  double width() const { return to - from; }
};

/// All of them, side by side; at least one, which has no width in a constant field. Where the TF has a step
/// at the greatest value, the last one has no width: of a mask, that is all of the inside. O(points).
std::vector<TfPiece> pieces_of(const TransferFunction& tf, ValueRange field);

/// Whether two materials look the same: without opacity the colour does not matter.
bool is_same(const Classified& a, const Classified& b);

/// Whether the TF has a step where the i-th piece begins.
bool is_step(const std::vector<TfPiece>& pieces, std::size_t i);

/// From the first to the last value at which the TF changes; of no width where it does nowhere, or in one
/// step.
ValueRange changing_range(const std::vector<TfPiece>& pieces);

/// The range of a table that holds all changes: in float32, and of a width that can be divided by.
ValueRange table_range(const std::vector<TfPiece>& pieces);

/// Opaque at any length that a step can have, per smallest spacing: tables hold no more, since infinity would
/// make 0 * infinity of a piece of no length.
inline constexpr double most_extinction = 1e30;

}  // namespace crest
