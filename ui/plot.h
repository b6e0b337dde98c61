#pragma once

#include <imgui.h>

#include <optional>
#include <span>

#include "presets/peaks.h"
#include "presets/transfer_function.h"
#include "ui/editor_state.h"

namespace crest {

/// Where the editor's plot is, and what its axes mean.
struct Plot {
  ImVec2 low, high;  ///< corners in pixels, low = top left
  ValueAxis axis;
  OpacityAxis opacity_axis;

  float x_of(double value) const;
  float y_of(double opacity) const {
    return high.y - float(opacity_axis.unit_of(opacity)) * (high.y - low.y);
  }
  double opacity_at(float y) const { return opacity_axis.opacity_at((high.y - y) / (high.y - low.y)); }
  ImVec2 place(const ControlPoint& point) const { return {x_of(point.value), y_of(point.opacity)}; }
};

/// The point within reach of the mouse, the nearest one; of several at one place the last.
std::optional<std::size_t> point_near(const Plot& plot, std::span<const ControlPoint> points, ImVec2 mouse);

/// Background, grid, and the labels of both axes.
void draw_axes(ImDrawList& list, const Plot& plot);
/// A map from the volume's values to the axis: v -> offset + scale * v.
struct ValueMap {
  double offset = 0, scale = 1;
  double operator()(double v) const { return offset + scale * v; }
};

/// From the volume's values to the TF's.
ValueMap data_to_domain(const TransferFunction& tf, ValueRange data);

/// How high a column of height 1 is, as a share of the plot's height.
inline constexpr float column_share = 0.94F;
/// Equal columns over a range of the volume's values as one filled shape.
void draw_columns(ImDrawList& list, const Plot& plot, ValueRange range, std::span<const float> heights,
                  ImU32 color, double alpha, ValueMap to_domain);
/// The curve, and the area under it in the TF's colours.
void draw_curve(ImDrawList& list, const Plot& plot, const TransferFunction& tf);
/// A stem and a diamond for each peak, filled when it is shown as a surface, and its value where there is
/// room.
void draw_peaks(ImDrawList& list, const Plot& plot, const TransferFunction& tf, std::span<const Peak> peaks);
void draw_points(ImDrawList& list, const Plot& plot, const TransferFunction& tf, const Selection& selection,
                 std::optional<std::size_t> hovered);

/// The range of values that the bar over the plot shifts and stretches: of the selected points, or of all.
ValueRange span_of(const TransferFunction& tf, const Selection& selection);
/// Which part of that bar is at `mouse`.
std::optional<EditorDrag::Kind> span_handle_at(const Plot& plot, ValueRange span, ImVec2 mouse);
void draw_span(ImDrawList& list, const Plot& plot, ValueRange span, std::optional<EditorDrag::Kind> held);
inline constexpr float span_height = 14;  ///< of the strip over the plot that it takes, unscaled

}  // namespace crest
