#include "ui/ray_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/style.h"

namespace crest {
namespace {

/// A rectangle with a horizontal axis of depth and a vertical one of some value.
struct Frame {
  ImVec2 low, high;  // low = top left
  ValueAxis depths;
  ValueRange values;

  float x_of(double depth) const {
    return float(std::clamp(depths.x_of(depth), double(low.x) - 1e4, double(high.x) + 1e4));
  }
  float y_of(double value) const {
    return high.y - float((value - values.min) / values.width()) * (high.y - low.y);
  }
  ImVec2 at(double depth, double value) const { return {x_of(depth), y_of(value)}; }
};

void draw_frame(ImDrawList& list, const Frame& frame, const char* title) {
  list.AddRectFilled(frame.low, frame.high, palette().plot);
  const AxisTicks values = axis_ticks(frame.values, int((frame.high.y - frame.low.y) / scaled(28)));
  for (const auto& tick : values.ticks) {
    const float y = frame.y_of(tick.value);
    list.AddLine({frame.low.x, y}, {frame.high.x, y}, palette().grid);
    const float width = ImGui::CalcTextSize(tick.label.c_str()).x;
    list.AddText({frame.low.x - width - scaled(5), y - ImGui::GetFontSize() / 2}, palette().secondary,
                 tick.label.c_str());
  }
  list.AddRect(frame.low, frame.high, palette().frame);
  list.AddText({frame.low.x + scaled(6), frame.low.y + scaled(3)}, palette().secondary, title);
}

void draw_depths(ImDrawList& list, const Frame& frame) {
  const AxisTicks ticks = axis_ticks(frame.depths.visible, int((frame.high.x - frame.low.x) / scaled(70)));
  for (const auto& tick : ticks.ticks) {
    const float x = frame.x_of(tick.value), width = ImGui::CalcTextSize(tick.label.c_str()).x;
    list.AddText({x - width / 2, frame.high.y + scaled(3)}, palette().secondary, tick.label.c_str());
  }
}

/// Draws a line through the points in sight, broken where a value is none.
class Line {
 public:
  Line(ImDrawList& list, const Frame& frame, ImU32 color, float width)
      : list_(list), frame_(frame), color_(color), width_(width) {}
  void add(double depth, double value) {
    if (std::isnan(value)) return end();
    const ImVec2 at = frame_.at(depth, value);
    // Of many points in one column of pixels the first and the extremes would do; two a pixel is close enough
    if (!points_.empty() && at.x - points_.back().x < 0.5F && std::abs(at.y - points_.back().y) < 0.5F)
      return;
    points_.push_back(at);
  }
  void end() {
    list_.AddPolyline(points_.data(), int(points_.size()), color_, ImDrawFlags_None, width_);
    points_.clear();
  }
  ~Line() { end(); }

 private:
  ImDrawList& list_;
  const Frame& frame_;
  ImU32 color_;
  float width_;
  std::vector<ImVec2> points_;
};

/// The places that are in sight, and one more to either side.
std::span<const RayPlace> in_sight(const ExactRay& ray, ValueRange visible) {
  const auto& places = ray.places;
  auto first = std::ranges::lower_bound(places, visible.min, {}, &RayPlace::depth);
  auto last = std::ranges::upper_bound(places, visible.max, {}, &RayPlace::depth);
  if (first != places.begin()) --first;
  if (last != places.end()) ++last;
  return {first, last};
}

ValueRange values_in_sight(const InspectedRay& ray, std::span<const Peak> surfaces, ValueRange visible) {
  ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const RayPlace& place : in_sight(ray.exact, visible))
    if (!std::isnan(place.value)) {
      range.min = std::min(range.min, place.value);
      range.max = std::max(range.max, place.value);
    }
  if (!(range.min <= range.max)) return {0, 1};
  const ValueRange met = range;
  for (const Peak& peak : surfaces)
    if (peak.value > met.min - met.width() / 2 && peak.value < met.max + met.width() / 2) {
      range.min = std::min(range.min, peak.value);
      range.max = std::max(range.max, peak.value);
    }
  const double margin = range.width() > 0 ? 0.06 * range.width() : std::max(1e-9, std::abs(range.min) * 1e-3);
  return {range.min - margin, range.max + margin};
}

void draw_field(ImDrawList& list, const Frame& frame, const InspectedRay& ray,
                std::span<const Peak> surfaces) {
  for (const Peak& peak : surfaces) {
    const float y = frame.y_of(peak.value);
    if (y > frame.low.y && y < frame.high.y)
      list.AddLine({frame.low.x, y}, {frame.high.x, y}, packed(peak.color, 0.8));
  }
  {
    Line line(list, frame, palette().curve, 1.5F);
    for (const RayPlace& place : in_sight(ray.exact, frame.depths.visible))
      line.add(place.depth, place.value);
  }
  // Samples nearer to each other than this would be a second line
  const bool has_room = ray.steps.size() < 2 || (frame.high.x - frame.low.x) /
                                                        float(frame.depths.visible.width()) *
                                                        float(ray.steps[1].depth - ray.steps[0].depth) >
                                                    2;
  if (has_room)
    for (const TracedStep& step : ray.steps) {
      if (step.depth < frame.depths.visible.min || step.depth > frame.depths.visible.max) continue;
      const double value = ray.exact.value_at(step.depth);
      if (!std::isnan(value)) list.AddCircleFilled(frame.at(step.depth, value), scaled(2), palette().accent);
    }
  for (const CheckedCrossing& crossing : ray.crossings.exact) {
    const ImVec2 at = frame.at(crossing.depth, crossing.value);
    const float side = scaled(4);
    if (at.x < frame.low.x || at.x > frame.high.x) continue;
    if (crossing.found || ray.steps.empty()) {
      list.AddCircle(at, side, palette().good, 0, 1.5F);
    } else {
      list.AddLine({at.x - side, at.y - side}, {at.x + side, at.y + side}, palette().error, 2);
      list.AddLine({at.x - side, at.y + side}, {at.x + side, at.y - side}, palette().error, 2);
    }
  }
}

void draw_opacity(ImDrawList& list, const Frame& frame, const InspectedRay& ray) {
  {
    Line line(list, frame, palette().curve, 1.5F);
    for (const RayPlace& place : in_sight(ray.exact, frame.depths.visible))
      line.add(place.depth, place.opacity);
  }
  Line line(list, frame, palette().accent, 1.5F);
  for (const TracedStep& step : ray.steps) line.add(step.depth, double(step.color.a));
}

}  // namespace

void draw_ray_plots(const InspectedRay& ray, std::span<const Peak> surfaces, const ValueAxis& depths,
                    ImVec2 low, ImVec2 size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetFontSize(), left = float(depths.left), right = left + float(depths.pixels);
  const float height = size.y - line - scaled(6), gap = scaled(6);
  const float middle = std::floor(low.y + height * field_plot_share);
  const Frame field{
      {left, low.y}, {right, middle - gap / 2}, depths, values_in_sight(ray, surfaces, depths.visible)};
  const Frame opacity{{left, middle + gap / 2}, {right, low.y + height}, depths, {-0.03, 1.03}};
  const auto draw = [&](const Frame& frame, const char* title, auto&& content) {
    draw_frame(list, frame, title);
    list.PushClipRect(frame.low, frame.high, true);
    content();
    list.PopClipRect();
  };
  draw(field, "field along the ray", [&] { draw_field(list, field, ray, surfaces); });
  draw(opacity, "opacity collected", [&] { draw_opacity(list, opacity, ray); });
  draw_depths(list, opacity);
}

}  // namespace crest
