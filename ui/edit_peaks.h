#pragma once

#include <span>

#include "ui/move_points.h"

namespace crest {

// What is done to whole peaks. `peak` is one of find_peaks(tf), in whatever units of value.

/// The points of a peak's top.
Selection top_of(const Peak& peak);

/// Shows a peak as a surface, or not.
void show_peak(TransferFunction& tf, const Peak& peak, bool shown);
/// Shows this one and hides the others; where that is so already, shows all.
void show_only(TransferFunction& tf, std::span<const Peak> peaks, std::size_t index);

/// Takes a peak away, and its feet where the curve beneath is the same without them.
void erase_peak(TransferFunction& tf, const Peak& peak);

/// Adds a peak of the same shape at another value. Returns its top.
Selection duplicate_peak(TransferFunction& tf, const Peak& peak, double value);

}  // namespace crest
