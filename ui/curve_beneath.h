#pragma once

#include "ui/edit_points.h"

namespace crest {

// The curve beneath is that of all points but those of spikes, and of the peaks and steps that move. What
// stands on it leaves no trace where it was.

/// `after` are the points of `before` with their new values, in the same order; those of `moving` moved. Feet
/// that stood on the curve beneath stand on it again, and what is between foot and top keeps its share of the
/// height.
void stand_on_curve(std::vector<ControlPoint>& after, const TransferFunction& before,
                    const Selection& moving);

/// After opacities or colours were edited: feet that stood on the curve in `before` stand on the new one, but
/// for those that were edited themselves. No point may have changed its place.
void keep_feet_on_curve(TransferFunction& tf, const TransferFunction& before);

/// Edits opacities or colours with edit(), and then does that.
template <class Edit>
void edit_above_curve(TransferFunction& tf, const Edit& edit) {
  const TransferFunction before = tf;
  edit();
  keep_feet_on_curve(tf, before);
}

}  // namespace crest
