#pragma once

#include <vector>

#include "presets/json_text.h"
#include "presets/transfer_function.h"

namespace crest {

// Lists of numbers as ParaView and vtk.js have them, of the points with these values.

/// x, r, g, b each.
Json flat_colors(const TransferFunction& tf, const std::vector<double>& values);
/// x, opacity each, and `shape` behind them: ParaView's midpoint and sharpness.
Json flat_opacities(const TransferFunction& tf, const std::vector<double>& values,
                    const std::vector<double>& shape);

}  // namespace crest
