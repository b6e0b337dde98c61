#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"

namespace crest {

// What a person does to the points of a transfer function, which stay in order. How they are moved is in
// move_points.h.

/// Indices of control points, ascending.
using Selection = std::vector<std::size_t>;
bool is_selected(const Selection& selection, std::size_t point);

/// A point with this colour and opacity, to 15 digits: so that what was calculated reads as a person would
/// write it.
ControlPoint point_at(double value, const Classified& curve);

/// Puts a point on the curve's colour; behind those that are at `value` already. Returns its index.
std::size_t insert_point(TransferFunction& tf, double value, double opacity);

/// Puts in a spike: two points on the curve, `width` apart, and the apex between them (three at one value
/// when width is 0). It is squeezed between the points that are there. Returns the apex's index.
std::size_t insert_peak(TransferFunction& tf, double value, double opacity, double width, glm::dvec3 color);

/// How wide a peak may be to be a spike, in values.
double widest_spike(const TransferFunction& tf);

/// The middle of the widest part of `range` that has no point: a place for a new peak.
double widest_gap(const TransferFunction& tf, ValueRange range);

/// Puts in a jump from the curve to `opacity`. Returns the index of its upper point.
std::size_t insert_step(TransferFunction& tf, double value, double opacity);

/// Makes a jump of a point: a second one at its value carries on from the left neighbour (or from 0). Returns
/// the index at which the point is now.
std::size_t make_step(TransferFunction& tf, std::size_t point);

void erase_points(TransferFunction& tf, const Selection& selection);

/// The colours that new peaks are given, in turn: those of Okabe and Ito, "Color Universal Design" (2008),
/// which the colour-blind tell apart, without black.
std::span<const glm::dvec3> peak_colors();
glm::dvec3 peak_color(std::size_t n);

/// The volume's range in the units of the TF's domain.
ValueRange range_in_domain(const TransferFunction& tf, ValueRange volume_range);

/// The TF's span laid over the volume's range; one whose points all share a value stays as it is.
TransferFunction fitted(const TransferFunction& tf, ValueRange volume_range);

/// The same TF in the other domain, for a volume of this range; a range of no width counts as one of 1.
TransferFunction in_domain(const TransferFunction& tf, Domain domain, ValueRange volume_range);

}  // namespace crest
