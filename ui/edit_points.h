#pragma once

#include <cstddef>
#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"

namespace crest {

/// What a person does to the points of a transfer function. All keep the values in order: a point goes as far
/// as its neighbour's value, which it may share.

/// Indices of control points, ascending.
using Selection = std::vector<std::size_t>;

/// Puts a point on the curve's colour; behind those that are at `value` already. Returns its index.
std::size_t insert_point(TransferFunction& tf, double value, double opacity);

/// Puts in a spike: two points on the curve, `width` apart, and the apex between them (three at one value
/// when width is 0). It is squeezed between the points that are there. Returns the apex's index.
std::size_t insert_peak(TransferFunction& tf, double value, double opacity, double width, glm::dvec3 color);

/// The middle of the widest part of `range` that has no point: a place for a new peak.
double widest_gap(const TransferFunction& tf, ValueRange range);

/// Puts in a jump from the curve to `opacity`. Returns the index of its upper point.
std::size_t insert_step(TransferFunction& tf, double value, double opacity);

/// Makes a jump of a point: a second one at its value carries on from the left neighbour (or from 0). Returns
/// the index at which the point is now.
std::size_t make_step(TransferFunction& tf, std::size_t point);

void erase_points(TransferFunction& tf, const Selection& selection);

/// How far a point can go while the selected ones move along: to the nearest neighbours that are not
/// selected, or without bound.
ValueRange room_of(const std::vector<ControlPoint>& points, std::size_t point, const Selection& selection);

/// The selection, and with the apex of a peak whose flanks are nearer than `reach` the flanks, too: such a
/// peak moves as a whole, since its apex alone has nowhere to go.
Selection with_near_flanks(const std::vector<ControlPoint>& points, const Selection& selection, double reach);

/// `before` with the selected points moved by `shift`, as far as all of them have room. The value of one of
/// them is rounded to a tenth of `resolution`, which 0 leaves out; the others keep their distances.
std::vector<ControlPoint> moved(const std::vector<ControlPoint>& before, const Selection& selection,
                                double shift, double resolution);

/// Sets the distance between a peak's flanks; their points move in proportion.
void set_peak_width(TransferFunction& tf, const Peak& peak, double width);

/// A hue for the n-th peak that differs well from those before it.
glm::dvec3 peak_color(std::size_t n);

/// The volume's range in the units of the TF's domain.
ValueRange range_in_domain(const TransferFunction& tf, ValueRange volume_range);

/// The TF's span laid over the volume's range; one whose points all share a value stays as it is.
TransferFunction fitted(const TransferFunction& tf, ValueRange volume_range);

/// The same TF in the other domain, for a volume of this range; a range of no width counts as one of 1.
TransferFunction in_domain(const TransferFunction& tf, Domain domain, ValueRange volume_range);

}  // namespace crest
