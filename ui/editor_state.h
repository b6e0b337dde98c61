#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "ui/histogram_cache.h"
#include "ui/move_points.h"
#include "ui/shown_values.h"
#include "ui/value_axis.h"

namespace crest {

/// What lies behind the transfer function: a histogram, or what else there is by value (value_curves.h).
enum class ValueCurve {
  none,
  values,
  log_values,
  visibility,
  log_visibility,
  area,
  log_area,
  gradient,
  enclosed,
  log_enclosed
};

/// What the mouse is dragging in the editor's plot.
struct EditorDrag {
  enum class Kind { none, points, axis, box, span, span_low, span_high };
  Kind kind = Kind::none;
  bool moves_points() const { return kind != Kind::none && kind != Kind::axis && kind != Kind::box; }
  ImVec2 start;             ///< where the button went down
  bool under_way = false;   ///< moved far enough to be a drag
  TransferFunction before;  ///< as it was
  Selection selected_before;
  ValueRange visible, whole;      ///< of the axis, held while points are dragged
  std::size_t grabbed = 0;        ///< of points, the one under the mouse
  std::optional<double> snapped;  ///< the value to which it snapped
};

/// What belongs to the transfer-function editor and is not in the document.
struct EditorState {
  Selection selection;
  std::optional<ValueRange> visible;      ///< the part of the axis in sight; without it, all
  std::optional<Domain> shown_domain;     ///< in which the TF was shown in the last frame
  std::optional<ValueRange> shown_range;  ///< of the volume then
  ShownCurve shown_curve;                 ///< the TF as it was shown last
  OpacityAxis opacity_axis;
  ValueCurve value_curve = ValueCurve::log_values;
  bool suggestions = true;               ///< marks of the peaks that the volume suggests
  std::optional<double> new_peak_width;  ///< in the TF's values; without it, a share of what is in sight
  Neighbours neighbours = Neighbours::free;
  bool snap = true;
  std::vector<double> landmarks;            ///< values to snap to, of the volume's histogram
  std::string note;                         ///< why something could not be done, until the next press
  bool type_value = false;                  ///< the value's field is to be typed in, next
  std::optional<std::size_t> hovered_peak;  ///< in the list of peaks, in this frame
  bool peak_rule = false;                   ///< the row of fields that say what a peak is
  EditorDrag drag;
  TransferFunction before_width;  ///< when the drag of a peak's width began
  HistogramCache histogram;
  double menu_value = 0, menu_opacity = 0;  ///< where the right-click menu was opened
};

}  // namespace crest
