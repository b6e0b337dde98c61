#pragma once

#include "presets/fields.h"
#include "ui/edit_points.h"

namespace crest {

// Moving control points along the axis of values: shapes go as a whole, and what stands on the curve beneath
// them stands on it where they arrive.

/// What happens to the points in the way of those that move: they are passed; they stop them; or they are
/// pushed along, spikes and steps as a whole.
enum class Neighbours { free, stop, push };

/// The points of a peak: from where its flanks begin to where they end. Flanks of several pieces, as a
/// Gaussian's, count as far as they go down alike on both sides.
struct PointRange {
  std::size_t first = 0, last = 0;
};
PointRange points_of(const TransferFunction& tf, const Peak& peak);

/// The selection with what belongs to it: with a peak's top its flanks, if one of them is nearer than
/// `reach`; with one point of a step the other.
Selection whole_of(const TransferFunction& tf, const Selection& selection,
                   double reach = std::numeric_limits<double>::infinity());

/// The points after a move, in order, and where each of them came to stand.
struct Moved {
  std::vector<ControlPoint> points;
  std::vector<std::size_t> now_at;  ///< by the index before
  Selection of(const Selection& before) const;
};

/// Puts points in the order of their values; those that share one keep theirs.
Moved in_order(const std::vector<ControlPoint>& points);

/// `before` with the points of `moving` shifted so that `anchor`, one of them, gets the value `to`. The feet
/// of peaks that move as a whole keep to the curve beneath, which is that of all other points, if they stood
/// on it; else shapes stay as they are. Only Neighbours::stop may keep the anchor from its value.
Moved moved(const TransferFunction& before, const Selection& moving, std::size_t anchor, double to,
            Neighbours neighbours);

/// The values that `anchor` can get before one of `moving` meets a point that does not move.
ValueRange room_of(const std::vector<ControlPoint>& points, const Selection& moving, std::size_t anchor);

/// The same as a field's rule, where neighbours stop what moves; else any value will do.
FieldRule value_rule(const std::vector<ControlPoint>& points, const Selection& moving, std::size_t anchor,
                     Neighbours neighbours);

/// Sets the distance between a peak's flanks; their points move in proportion, as far as their neighbours.
/// Feet keep to the curve beneath.
void set_peak_width(TransferFunction& tf, const Peak& peak, double width);
/// That distance, without what the subtraction gets wrong.
double peak_width(const TransferFunction& tf, const Peak& peak);

}  // namespace crest
