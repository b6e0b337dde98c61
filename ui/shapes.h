#pragma once

#include <span>
#include <string_view>

#include "ui/edit_points.h"

namespace crest {

/// What can be put on the curve. A spike is a tent that is narrow enough to be taken out of the volume
/// rendering; a Gaussian is a polyline.
enum class Shape { spike, tent, box, gaussian, ramp, step };

/// Most that a Gaussian's polyline is off, of its height, in as few points as that takes on the curve itself.
inline constexpr double gaussian_error = 0.01;

/// A corner of a shape: its place from the shape's middle, in its width, and its share of the way from the
/// curve beneath to the shape's opacity.
struct ShapeCorner {
  double place = 0, height = 0;
};
/// From -1/2 to 1/2. A Gaussian's width is 7 of its standard deviations; a step has none.
std::span<const ShapeCorner> corners_of(Shape shape);

/// Puts a shape on the curve, in place of the points between its feet; a spike and a step leave those. What
/// its ends stand on stays as it is; behind a step or a ramp the curve goes on from its opacity. Returns the
/// points that stand for it: one top, or all of it.
Selection insert_shape(TransferFunction& tf, Shape shape, double value, double opacity, double width,
                       glm::dvec3 color);

/// Opacities over the whole range of the points, from 0 to `opacity`; colours stay as they are.
enum class OpacityShape { flat, ramp_up, ramp_down, tent, gaussian };
TransferFunction with_opacities(const TransferFunction& tf, OpacityShape shape, double opacity);

std::string_view label_of(Shape shape);
std::string_view label_of(OpacityShape shape);

}  // namespace crest
