#include <algorithm>
#include <cmath>

#include "ui/arrange_points.h"
#include "ui/plot.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace crest {
namespace {

constexpr float grip = 7;  // half a handle's width

/// The strip that the bar lies in.
std::pair<float, float> strip_of(const Plot& plot) {
  return {plot.low.y - scaled(span_height - 3), plot.low.y - scaled(3)};
}

}  // namespace

ValueRange span_of(const TransferFunction& tf, const Selection& selection) {
  return values_of(tf, selected_or_all(tf, selection));
}

std::optional<EditorDrag::Kind> span_handle_at(const Plot& plot, ValueRange span, ImVec2 mouse) {
  const auto [top, bottom] = strip_of(plot);
  if (mouse.y < top - 1 || mouse.y > bottom + 1) return std::nullopt;
  const float low = plot.x_of(span.min), high = plot.x_of(span.max), reach = scaled(grip);
  // Of ends that are close together the outer halves.
  if (std::abs(mouse.x - high) <= reach && mouse.x >= std::min((low + high) / 2, high))
    return EditorDrag::Kind::span_high;
  if (std::abs(mouse.x - low) <= reach) return EditorDrag::Kind::span_low;
  if (mouse.x > low && mouse.x < high) return EditorDrag::Kind::span;
  return std::nullopt;
}

void draw_span(ImDrawList& list, const Plot& plot, ValueRange span, std::optional<EditorDrag::Kind> held) {
  const auto [top, bottom] = strip_of(plot);
  const float margin = scaled(grip);
  const float low = plot.x_of(span.min), high = plot.x_of(span.max), middle = std::floor((top + bottom) / 2);
  list.PushClipRect({plot.low.x - margin, top - 1}, {plot.high.x + margin, bottom + 1}, true);
  const auto color = [&](EditorDrag::Kind kind) {
    return held == kind ? palette().accent : palette().secondary;
  };
  list.AddRectFilled({low, middle - scaled(2)}, {high, middle + scaled(2)}, color(EditorDrag::Kind::span));
  const float half = scaled(3);
  list.AddRectFilled({low - half, top}, {low + half, bottom}, color(EditorDrag::Kind::span_low), scaled(2));
  list.AddRectFilled({high - half, top}, {high + half, bottom}, color(EditorDrag::Kind::span_high),
                     scaled(2));
  list.PopClipRect();
}

}  // namespace crest
