#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// The two-dimensional pre-integration table (Engel et al. 2001): what a segment of one fixed length collects
/// on which the field goes linearly from a front value to a back value, premultiplied RGBA, with its own
/// absorption.
struct PreintegrationTable {
  int bins = 0;       ///< values on each axis, at least 2: the first and the last are the range's ends
  ValueRange range;   ///< of the field; never of no width
  double length = 0;  ///< of a segment, in smallest spacings
  std::vector<glm::vec4> entries;  ///< bins*bins, front value fastest

  glm::vec4 at(int front, int back) const {
    return entries[std::size_t(back) * std::size_t(bins) + std::size_t(front)];
  }
};

inline constexpr int largest_preintegration_table = 2048;

/// Builds it in O(bins^2), as Lum et al. 2004 along the diagonals: segments over k bins are k slabs, each
/// over one bin and a k-th of the length, and the slabs of a diagonal are the same for all its segments. A
/// slab takes its bin's mean emission and extinction (mean_material.h), so that a spike narrower than a bin
/// keeps its integral, and opacity is exact; colour is exact to second order in the bins' width.
///
/// Where Lum et al. take a slab off the front of a running product, by division, this joins the end of one
/// block of k slabs to the beginning of the next: "over" is associative but, behind an opaque slab, has
/// no inverse. Runs on all cores. `tf` is resolved. Throws Error for bins outside
/// 2..largest_preintegration_table.
PreintegrationTable build_preintegration_table(const TransferFunction& tf, ValueRange field,
                                               double smallest_spacing, double length, int bins);

}  // namespace crest
