#pragma once

#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// A TF sampled for the GPU: colour, and extinction per smallest spacing, at equidistant values.
struct TfTable {
  ValueRange range;  ///< of the first and the last entry: float32 numbers, never the same
  std::vector<glm::vec4> entries;
};

/// Most entries of a table: 128 KiB (Knoll et al. 2009, section 6).
inline constexpr int largest_tf_table = 8192;

/// What a table of enough entries keeps, where it is interpolated linearly. Its opacity may be wrong, for a
/// ray that stays at one value however far it goes through the volume, by `smooth`, between the TF's points;
/// and at a point, for one smallest spacing, by `corner`. Where texture units have weights of 8 bits, they
/// add at most `smooth` for one smallest spacing. Premultiplied colour keeps the same.
struct TfTableLimits {
  double smooth = 1e-5, corner = 1e-4;
};

/// How large a table a TF needs.
struct TfTableSize {
  int entries = 2;   ///< 2..largest_tf_table
  double error = 0;  ///< largest, of the opacity and premultiplied colour of one smallest spacing
  /// The narrowest part in which the TF changes within less than one entry of the largest table (a step has
  /// no width at all), so that DVR shows it blurred, or not at all.
  std::optional<ValueRange> blurred;
};

/// The smallest table of `tf` (resolved) that keeps the limits, in O(points). `longest_ray` is in smallest
/// spacings.
TfTableSize tf_table_size(const TransferFunction& tf, ValueRange field, double smallest_spacing,
                          double longest_ray, const TfTableLimits& limits = {});

/// Post-classification's table, over the part of the TF in which it changes and that `field` reaches: beyond
/// it the TF is constant, or never asked for. `tf` is resolved.
TfTable build_tf_table(const TransferFunction& tf, ValueRange field, double smallest_spacing, int entries);

/// Whether all of the field's values show the same.
bool is_constant(const TransferFunction& tf, ValueRange field);

/// The greatest opacity of the TF in the field's range. The point of a spike of no width is not in it: no
/// sample meets it.
double largest_opacity(const TransferFunction& tf, ValueRange field);

}  // namespace crest
