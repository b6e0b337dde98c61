#pragma once

#include <string>
#include <utility>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// Which points of one transfer function became which of another. Points that are equal on both sides are in
/// none of the lists.
struct PointAlignment {
  std::vector<std::pair<std::size_t, std::size_t>> changed;  ///< before, after
  std::vector<std::size_t> removed, added;                   ///< where they are not as many
};

/// By the longest common subsequence of equal points; where very many differ, by their order alone.
PointAlignment align_points(const std::vector<ControlPoint>& before, const std::vector<ControlPoint>& after);

/// As preset_changes(), of the points.
std::vector<std::string> point_changes(const TransferFunction& before, const TransferFunction& after);

}  // namespace crest
