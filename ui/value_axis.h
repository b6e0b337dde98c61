#pragma once

#include <string>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// The part of the value axis that is in sight, laid over `pixels` pixels from `left`.
struct ValueAxis {
  ValueRange visible{0, 1};
  double left = 0, pixels = 1;

  double x_of(double value) const { return left + (value - visible.min) / visible.width() * pixels; }
  double value_at(double x) const { return visible.min + (x - left) / pixels * visible.width(); }
  double value_per_pixel() const { return visible.width() / pixels; }
};

/// Least share of the whole range that can be zoomed to.
inline constexpr double deepest_zoom = 1e-12;

/// A range to show that holds both, with a margin; always finite and of some width.
ValueRange whole_range(ValueRange volume, ValueRange points);

/// `visible` scaled by `factor` (below 1 = closer) about `value`, which keeps its place; no deeper than
/// `deepest_zoom` (nor than doubles can tell apart), no wider than `whole`, and inside it.
ValueRange zoom(ValueRange visible, ValueRange whole, double value, double factor);

/// `visible` moved by `shift`, within `whole`.
ValueRange pan(ValueRange visible, ValueRange whole, double shift);

/// Marks on an axis. Where the values agree in their first digits, these are told once, as `offset`, and the
/// labels count from it.
struct AxisTicks {
  struct Tick {
    double value;
    std::string label;
  };
  std::vector<Tick> ticks;
  std::string offset;  ///< e.g. "120.5 +"; empty when the labels are whole values
};
AxisTicks axis_ticks(ValueRange visible, int most);

/// `value` as the decimal number with the fewest digits that differs from it by less than a tenth of
/// `resolution`.
double round_to_resolution(double value, double resolution);

/// Opacity laid over the unit interval, 0 at the bottom: as it is, or its logarithm from 1e-6 to 1.
struct OpacityAxis {
  bool logarithmic = false;
  double unit_of(double opacity) const;
  double opacity_at(double unit) const;  ///< in [0, 1]; at the bottom exactly 0
};
inline constexpr int opacity_decades = 6;

}  // namespace crest
