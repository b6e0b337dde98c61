#pragma once

#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// How far apart a target keeps points, in units of the last place of 32-bit float (2^-23 of the value, or of
/// `least_size` of the points' range where that is more).
struct Separation {
  double units = 11;
  double least_size = 1;
  bool steps_only =
      false;  ///< only points that share a value are moved, and never past half the way to their neighbours
};

/// For targets that keep double precision but sort, rescale or round their points: only steps are drawn
/// apart, far enough that a rescale and 32-bit float keep their order.
inline constexpr Separation drawn_apart{.units = 11, .least_size = 1, .steps_only = true};
/// For 3D Slicer, whose reader moves a point that is nearer than 10 units to the one before it.
inline constexpr Separation slicer_apart{.units = 11, .least_size = 1.0 / 128, .steps_only = false};

/// The points' values, strictly increasing. Of points that are too near to each other one stays where it is:
/// the greatest opacity where it is higher than both ends (a spike keeps its value), else the last (a step
/// still holds at its value itself); the others are moved away from it.
std::vector<double> separated_values(const TransferFunction& tf, Separation separation);

/// How far the farthest point was moved.
double farthest_move(const TransferFunction& tf, const std::vector<double>& values);

}  // namespace crest
