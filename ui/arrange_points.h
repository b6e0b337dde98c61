#pragma once

#include "ui/move_points.h"

namespace crest {

// Several points at once. Values and opacities are those of the selected points; nothing else changes but the
// order, where points pass others.

/// The values of the selection laid from one range over another: window and level. A range of no width is
/// shifted.
Moved stretched(const TransferFunction& before, const Selection& selection, ValueRange from, ValueRange to);

/// Turned about the middle of its values.
Moved mirrored(const TransferFunction& before, const Selection& selection);

enum class Alignment { least, mean, greatest };
Moved with_values_aligned(const TransferFunction& before, const Selection& selection, Alignment alignment);
void align_opacities(TransferFunction& tf, const Selection& selection, Alignment alignment);

/// The same distance between each and the next, from the first to the last.
Moved with_values_distributed(const TransferFunction& before, const Selection& selection);
/// Opacities on the line from the first point to the last, by value.
void interpolate_opacities(TransferFunction& tf, const Selection& selection);

/// What lies on zero stays there; none goes beyond 1. Opacities that surfaces have of their own go along.
void scale_opacities(TransferFunction& tf, const Selection& selection, double factor);

Selection everything(const TransferFunction& tf);
/// All points where none is selected, or only one.
Selection selected_or_all(const TransferFunction& tf, const Selection& selection);
ValueRange values_of(const TransferFunction& tf, const Selection& selection);

}  // namespace crest
