#include "ui/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ui/style.h"
#include "ui/widgets.h"

namespace crest {
namespace {

constexpr float reach_pixels = 9;
constexpr float far_away = 1e6F;  // pixels; what lies further off is drawn there

struct CurveVertex {
  ImVec2 place;
  glm::dvec3 color;
};

CurveVertex vertex_at(const Plot& plot, double value, const Classified& c) {
  return {{plot.x_of(value), plot.y_of(c.opacity)}, c.color};
}

/// On a logarithmic axis a straight flank is bent: places between its ends, every few pixels.
void add_bend(std::vector<CurveVertex>& curve, const Plot& plot, double from, double to,
              const TransferFunction& tf) {
  const double pixels = (to - from) / plot.axis.value_per_pixel();
  const int parts = int(std::clamp(pixels / 4, 1.0, 150.0));
  for (int i = 1; i < parts; ++i) {
    const double value = from + (to - from) * i / parts;
    if (value > from && value < to) curve.push_back(vertex_at(plot, value, evaluate(tf, value)));
  }
}

/// The curve over the visible part, in order of value.
std::vector<CurveVertex> curve_of(const Plot& plot, const TransferFunction& tf) {
  const ValueRange visible = plot.axis.visible;
  std::vector<CurveVertex> curve{vertex_at(plot, visible.min, evaluate_right(tf, visible.min))};
  double from = visible.min;
  const auto bend_to = [&](double to) {
    if (plot.opacity_axis.logarithmic) add_bend(curve, plot, from, to, tf);
    from = to;
  };
  for (const ControlPoint& point : tf.points)
    if (point.value > visible.min && point.value < visible.max) {
      bend_to(point.value);
      curve.push_back({plot.place(point), point.color});
    }
  bend_to(visible.max);
  curve.push_back(vertex_at(plot, visible.max, evaluate_left(tf, visible.max)));
  return curve;
}

/// A strip between the places and the plot's floor, as one mesh.
void fill_below(ImDrawList& list, float floor, std::span<const CurveVertex> curve, double alpha) {
  if (curve.size() < 2) return;
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
  const int quads = int(curve.size()) - 1;
  list.PrimReserve(quads * 6, quads * 4);
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const CurveVertex &a = curve[i], &b = curve[i + 1];
    const auto first = ImDrawIdx(list._VtxCurrentIdx);
    for (const int corner : {0, 1, 2, 0, 2, 3}) list.PrimWriteIdx(ImDrawIdx(first + corner));
    list.PrimWriteVtx(a.place, white, packed(a.color, alpha));
    list.PrimWriteVtx(b.place, white, packed(b.color, alpha));
    list.PrimWriteVtx({b.place.x, floor}, white, packed(b.color, alpha));
    list.PrimWriteVtx({a.place.x, floor}, white, packed(a.color, alpha));
  }
}

void label(ImDrawList& list, ImVec2 place, float align, const char* text, ImU32 color) {
  const ImVec2 size = ImGui::CalcTextSize(text);
  list.AddText({std::round(place.x - align * size.x), std::round(place.y)}, color, text);
}

std::string opacity_text(double opacity) {
  return opacity > 0 && opacity < 0.01 ? fmt::format("{:.0e}", opacity) : fmt::format("{}", opacity);
}

void draw_opacity_axis(ImDrawList& list, const Plot& plot) {
  static constexpr double linear[] = {0, 0.25, 0.5, 0.75, 1};
  static constexpr double decades[] = {0, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1};
  const auto marks =
      plot.opacity_axis.logarithmic ? std::span<const double>(decades) : std::span<const double>(linear);
  const float height = ImGui::GetFontSize();
  for (const double opacity : marks) {
    const float y = std::round(plot.y_of(opacity));
    list.AddLine({plot.low.x, y}, {plot.high.x, y}, palette().grid);
    const float text_y = std::clamp(y - height / 2, plot.low.y - height / 2, plot.high.y - height * 0.8F);
    label(list, {plot.low.x - scaled(6), text_y}, 1, opacity_text(opacity).c_str(), palette().secondary);
  }
}

void draw_value_axis(ImDrawList& list, const Plot& plot) {
  const int most = std::max(2, int(plot.axis.pixels / scaled(60)));
  const AxisTicks ticks = axis_ticks(plot.axis.visible, most);
  const float text_y = plot.high.y + scaled(5);
  for (const AxisTicks::Tick& tick : ticks.ticks) {
    const float x = std::round(plot.x_of(tick.value));
    list.AddLine({x, plot.low.y}, {x, plot.high.y}, palette().grid);
    list.AddLine({x, plot.high.y}, {x, plot.high.y + scaled(4)}, palette().secondary);
    const float half = ImGui::CalcTextSize(tick.label.c_str()).x / 2;
    if (x + half > plot.high.x + scaled(8)) continue;
    label(list, {x, text_y}, 0.5F, tick.label.c_str(), palette().secondary);
  }
  if (!ticks.offset.empty())
    label(list, {plot.high.x, text_y + ImGui::GetFontSize() + scaled(1)}, 1, ticks.offset.c_str(),
          palette().text);
}

void draw_diamond(ImDrawList& list, ImVec2 at, float radius, ImU32 color, bool filled) {
  const ImVec2 corners[] = {
      {at.x, at.y - radius}, {at.x + radius, at.y}, {at.x, at.y + radius}, {at.x - radius, at.y}};
  if (filled) list.AddConvexPolyFilled(corners, 4, color);
  list.AddPolyline(corners, 4, filled ? palette().curve : palette().secondary, ImDrawFlags_Closed,
                   scaled(1.2F));
}

}  // namespace

float Plot::x_of(double value) const {
  return float(std::clamp(axis.x_of(value), double(low.x) - far_away, double(high.x) + far_away));
}

std::optional<std::size_t> point_near(const Plot& plot, std::span<const ControlPoint> points, ImVec2 mouse) {
  std::optional<std::size_t> nearest;
  const float reach = scaled(reach_pixels);
  float best = reach * reach;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ImVec2 place = plot.place(points[i]);
    const float dx = place.x - mouse.x, dy = place.y - mouse.y, distance = dx * dx + dy * dy;
    if (distance <= best) {
      best = distance;
      nearest = i;
    }
  }
  return nearest;
}

void draw_axes(ImDrawList& list, const Plot& plot) {
  list.AddRectFilled(plot.low, plot.high, palette().plot);
  draw_opacity_axis(list, plot);
  draw_value_axis(list, plot);
}

ValueMap data_to_domain(const TransferFunction& tf, ValueRange data) {
  if (tf.domain == Domain::data) return {};
  const double width = data.width() > 0 ? data.width() : 1;
  return {-data.min / width, 1 / width};
}

void draw_columns(ImDrawList& list, const Plot& plot, ValueRange range, std::span<const float> heights,
                  ImU32 packed_color, double alpha, ValueMap to_domain) {
  const ImVec4 parts = ImGui::ColorConvertU32ToFloat4(packed_color);
  const glm::dvec3 color(parts.x, parts.y, parts.z);
  const double columns = double(heights.size());
  const float height = (plot.high.y - plot.low.y) * column_share;
  std::vector<CurveVertex> outline;
  outline.reserve(heights.size() * 2);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double from = range.min + range.width() * double(i) / columns;
    const double to = range.min + range.width() * double(i + 1) / columns;
    const float left = plot.x_of(to_domain(from)), right = plot.x_of(to_domain(to));
    if (right < plot.low.x || left > plot.high.x) continue;
    const float y = plot.high.y - heights[i] * height;
    outline.push_back({{left, y}, color});
    outline.push_back({{std::max(right, left + 1), y}, color});
  }
  fill_below(list, plot.high.y, outline, alpha);
}

void draw_curve(ImDrawList& list, const Plot& plot, const TransferFunction& tf) {
  if (tf.points.empty()) return;
  const std::vector<CurveVertex> curve = curve_of(plot, tf);
  fill_below(list, plot.high.y, curve, 0.55);
  std::vector<ImVec2> places;
  places.reserve(curve.size());
  for (const CurveVertex& v : curve) places.push_back(v.place);
  list.AddPolyline(places.data(), int(places.size()), palette().curve, ImDrawFlags_None, scaled(1.5F));
}

void draw_peaks(ImDrawList& list, const Plot& plot, const TransferFunction& tf, std::span<const Peak> peaks) {
  ImVec2 taken_low{-far_away, -far_away}, taken_high = taken_low;  // by the last label
  for (const Peak& peak : peaks) {
    if (peak.last_point >= tf.points.size()) continue;  // found before the last edit
    const ControlPoint &first = tf.points[peak.first_point], &last = tf.points[peak.last_point];
    const float x = plot.x_of((first.value + last.value) / 2);
    if (x < plot.low.x - 1 || x > plot.high.x + 1) continue;
    const float y = plot.y_of(peak.opacity);
    const ImU32 stem = peak.shown ? packed(first.color, 0.9) : palette().secondary;
    list.AddLine({x, plot.high.y}, {x, y}, stem, scaled(1.5F));
    draw_diamond(list, {x, y}, scaled(7), packed(first.color), peak.shown);
    const std::string text = short_text((first.value + last.value) / 2);
    const float width = ImGui::CalcTextSize(text.c_str()).x, height = ImGui::GetFontSize();
    // Above the diamond, or beside it where the plot ends.
    const bool above = y - scaled(15) - height > plot.low.y;
    const float beside = x + scaled(15) + width < plot.high.x ? x + scaled(15) : x - scaled(15) - width;
    const float left =
        above ? std::clamp(x - width / 2, plot.low.x + 2, std::max(plot.low.x + 2, plot.high.x - width - 2))
              : beside;
    const float top = above ? y - scaled(14) - height : y - height / 2;
    const bool overlaps = left < taken_high.x + scaled(6) && top < taken_high.y && top + height > taken_low.y;
    if (overlaps) continue;
    taken_low = {left, top};
    taken_high = {left + width, top + height};
    list.AddText({std::round(left) + 1, std::round(top) + 1}, palette().plot, text.c_str());
    list.AddText({std::round(left), std::round(top)}, peak.shown ? palette().text : palette().secondary,
                 text.c_str());
  }
}

void draw_points(ImDrawList& list, const Plot& plot, const TransferFunction& tf, const Selection& selection,
                 std::optional<std::size_t> hovered) {
  const bool many = tf.points.size() > 100;
  for (std::size_t i = 0; i < tf.points.size(); ++i) {
    const ImVec2 at = plot.place(tf.points[i]);
    if (at.x < plot.low.x - 8 || at.x > plot.high.x + 8) continue;
    const bool selected = std::binary_search(selection.begin(), selection.end(), i);
    const float radius = scaled(selected ? 6.5F : hovered == i ? 5.5F : many ? 2.5F : 4.5F);
    const ImU32 ring = selected || hovered == i ? palette().emphasis : palette().curve;
    const float edge = scaled(selected ? 2 : 1);
    // Seen beside points of any colour
    if (selected && !many) list.AddCircle(at, scaled(12), palette().accent, 0, scaled(2.5F));
    const auto corner = [&](float r) {
      return std::pair{ImVec2(at.x - r, at.y - r), ImVec2(at.x + r, at.y + r)};
    };
    const auto [outer_low, outer_high] = corner(radius);
    const auto [inner_low, inner_high] = corner(radius - edge);
    list.AddRectFilled(outer_low, outer_high, ring);
    list.AddRectFilled(inner_low, inner_high, packed(tf.points[i].color));
  }
}

}  // namespace crest
