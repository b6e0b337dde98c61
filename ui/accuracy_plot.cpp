#include "ui/accuracy_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>

#include "ui/style.h"
#include "ui/widgets.h"

namespace crest {
namespace {

constexpr float reach_pixels = 12;
constexpr double margin = 1.5;         // beyond the first and the last point
constexpr double least_span = 20;      // from an axis' low end to its high end
constexpr double least_error = 1e-12;  // far below the rounding of 32-bit float

/// Circle, square, triangle, diamond, triangle: corners about the middle.
constexpr glm::vec2 square[] = {{-0.9F, -0.9F}, {0.9F, -0.9F}, {0.9F, 0.9F}, {-0.9F, 0.9F}};
constexpr glm::vec2 triangle_up[] = {{0, -1.2F}, {1.1F, 0.8F}, {-1.1F, 0.8F}};
constexpr glm::vec2 diamond[] = {{0, -1.25F}, {1.25F, 0}, {0, 1.25F}, {-1.25F, 0}};
constexpr glm::vec2 triangle_down[] = {{0, 1.2F}, {-1.1F, -0.8F}, {1.1F, -0.8F}};
constexpr std::span<const glm::vec2> polygons[] = {{}, square, triangle_up, diamond, triangle_down};

std::size_t index_of(const Method& method) {
  return std::size_t(std::ranges::find(methods(), method.id, &Method::id) - methods().begin());
}

LogAxis axis_over(double least, double most) {
  if (!(least <= most)) return {1, 100};
  least /= margin;
  most *= margin;
  if (const double lacking = std::sqrt(least_span * least / most); lacking > 1) {
    least /= lacking;
    most *= lacking;
  }
  return {least, most};
}

struct Tick {
  double value;
  bool labelled;
};

/// 1, 2, ... 9 of each decade; labelled are the decades, and 2 and 5 where there is room for `room` pixels a
/// label.
std::vector<Tick> ticks_of(const LogAxis& axis, float room) {
  std::vector<Tick> ticks;
  const int first = int(std::floor(std::log10(axis.low))), last = int(std::floor(std::log10(axis.high)));
  const double pixels = std::abs(axis.to - axis.from) / std::log10(axis.high / axis.low);  // of a decade
  const int every = std::max(1, int(std::ceil(room / pixels)));
  const bool fine = pixels * std::log10(2.0) > room;
  for (int decade = first; decade <= last; ++decade)
    for (int digit = 1; digit < 10; ++digit) {
      const double value = digit * std::pow(10.0, decade);
      if (value < axis.low || value > axis.high) continue;
      ticks.push_back({value, digit == 1 ? decade % every == 0 : fine && (digit == 2 || digit == 5)});
    }
  return ticks;
}

std::string tick_text(double value) {
  if (value >= 1e-3 && value < 1e5) return fmt::format("{:.6g}", value);
  const int decade = int(std::floor(std::log10(value * 1.000001)));
  return fmt::format("{:.0f}e{}", value / std::pow(10.0, decade), decade);
}

void draw_error_axis(ImDrawList& list, const AccuracyPlot& plot) {
  const float height = ImGui::GetFontSize();
  const auto label = [&](float y, const std::string& text) {
    const float x = plot.low.x - scaled(6) - ImGui::CalcTextSize(text.c_str()).x;
    list.AddText({std::round(x), std::round(y - height / 2)}, palette().secondary, text.c_str());
  };
  for (const Tick& tick : ticks_of(plot.error, height * 2)) {
    const float y = std::round(plot.error.place(tick.value));
    list.AddLine({plot.low.x, y}, {plot.high.x, y}, faded(palette().grid, tick.labelled ? 1 : 0.4F));
    if (tick.labelled) label(y, tick_text(tick.value));
  }
  if (!plot.has_zero) return;
  list.AddLine({plot.low.x, plot.error.from}, {plot.high.x, plot.error.from}, palette().frame);
  label((plot.error.from + plot.high.y) / 2, "0");
}

void draw_time_axis(ImDrawList& list, const AccuracyPlot& plot) {
  const char* unit = "ms a frame";
  const float text_y = plot.high.y + scaled(5), unit_x = plot.high.x - ImGui::CalcTextSize(unit).x;
  list.AddText({unit_x, text_y}, palette().secondary, unit);
  for (const Tick& tick : ticks_of(plot.ms, scaled(34))) {
    const float x = std::round(plot.ms.place(tick.value));
    list.AddLine({x, plot.low.y}, {x, plot.high.y}, faded(palette().grid, tick.labelled ? 1 : 0.4F));
    if (!tick.labelled) continue;
    const std::string text = tick_text(tick.value);
    const float half = ImGui::CalcTextSize(text.c_str()).x / 2;
    if (x + half < unit_x - scaled(8))
      list.AddText({std::round(x - half), text_y}, palette().secondary, text.c_str());
  }
}

}  // namespace

float LogAxis::place(double value) const {
  return from + (to - from) * float(std::log(value / low) / std::log(high / low));
}

std::vector<MethodLine> method_lines(std::span<const Measurement> measured, const ExactAnswer& answer,
                                     const ErrorMeasure& measure) {
  std::vector<MethodLine> lines;
  const auto all = points_against(measured, answer, measure);
  for (const Method& method : methods()) {
    MethodLine line{&method, {}};
    for (const AnswerPoint& p : all)
      if (measured[p.index].method == method.id && p.point.ms > 0 && std::isfinite(p.point.ms) &&
          std::isfinite(p.point.error))
        line.points.push_back(p);
    std::ranges::sort(line.points, std::greater{},
                      [&](const AnswerPoint& p) { return measured[p.index].step; });
    if (!line.points.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

std::optional<WorkPrecision> point_at_step(const MethodLine& line, std::span<const Measurement> measured,
                                           double step) {
  const auto step_of = [&](const AnswerPoint& p) { return measured[p.index].step; };
  const auto fine = std::ranges::lower_bound(line.points, step, std::greater{}, step_of);
  if (fine == line.points.end()) return std::nullopt;
  if (step_of(*fine) == step || !line.method->has_step) return fine->point;
  if (fine == line.points.begin()) return std::nullopt;
  const AnswerPoint &a = *std::prev(fine), &b = *fine;
  const double share = std::log(step / step_of(a)) / std::log(step_of(b) / step_of(a));
  const auto between = [&](double from, double to) {
    return from > 0 && to > 0 ? from * std::pow(to / from, share) : share < 0.5 ? from : to;
  };
  return WorkPrecision{between(a.point.ms, b.point.ms), between(a.point.error, b.point.error)};
}

ImVec2 AccuracyPlot::place(WorkPrecision point) const {
  const bool is_zero = point.error < error.low;
  return {ms.place(point.ms), is_zero ? (error.from + high.y) / 2 : error.place(point.error)};
}

AccuracyPlot accuracy_plot(std::span<const MethodLine> lines, double target, ImVec2 low, ImVec2 high) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  AccuracyPlot plot;
  plot.low = {low.x + ImGui::CalcTextSize("0.001").x + scaled(8), low.y + scaled(4)};
  plot.high = {high.x - scaled(2), high.y - ImGui::GetFontSize() - scaled(6)};
  double least_ms = infinity, most_ms = 0, least = infinity, most = 0;
  for (const MethodLine& line : lines)
    for (const AnswerPoint& p : line.points) {
      least_ms = std::min(least_ms, p.point.ms);
      most_ms = std::max(most_ms, p.point.ms);
      most = std::max(most, p.point.error);
      if (p.point.error > least_error)
        least = std::min(least, p.point.error);
      else
        plot.has_zero = true;
    }
  if (target > least_error) {
    least = std::min(least, target);
    most = std::max(most, target);
  }
  plot.ms = axis_over(least_ms, most_ms);
  plot.ms.from = plot.low.x;
  plot.ms.to = plot.high.x;
  plot.error = axis_over(least, most);
  plot.error.from = plot.high.y - (plot.has_zero ? std::round(ImGui::GetFontSize() * 1.5F) : 0);
  plot.error.to = plot.low.y;
  return plot;
}

std::optional<std::size_t> point_near(const AccuracyPlot& plot, std::span<const MethodLine> lines,
                                      ImVec2 mouse) {
  std::optional<std::size_t> nearest;
  float best = scaled(reach_pixels) * scaled(reach_pixels);
  for (const MethodLine& line : lines)
    for (const AnswerPoint& p : line.points) {
      const ImVec2 at = plot.place(p.point);
      const float dx = at.x - mouse.x, dy = at.y - mouse.y, distance = dx * dx + dy * dy;
      if (distance > best) continue;
      best = distance;
      nearest = p.index;
    }
  return nearest;
}

ImU32 color_of(const Method& method) { return palette().series[index_of(method) % palette().series.size()]; }

void draw_mark(ImDrawList& list, ImVec2 at, float radius, const Method& method, bool filled, float alpha) {
  const ImU32 edge = faded(color_of(method), alpha), inner = filled ? edge : palette().plot;
  const auto polygon = polygons[index_of(method) % std::size(polygons)];
  if (polygon.empty()) {
    list.AddCircleFilled(at, radius, inner, 16);
    list.AddCircle(at, radius, edge, 16, scaled(1.4F));
    return;
  }
  std::vector<ImVec2> corners;
  for (const glm::vec2 corner : polygon)
    corners.push_back({at.x + radius * corner.x, at.y + radius * corner.y});
  list.AddConvexPolyFilled(corners.data(), int(corners.size()), inner);
  list.AddPolyline(corners.data(), int(corners.size()), edge, ImDrawFlags_Closed, scaled(1.4F));
}

void draw_axes(ImDrawList& list, const AccuracyPlot& plot) {
  draw_error_axis(list, plot);
  draw_time_axis(list, plot);
}

void draw_target(ImDrawList& list, const AccuracyPlot& plot, double target) {
  const bool is_zero = target < plot.error.low;
  const float y = is_zero ? plot.error.from : std::round(plot.error.place(target));
  list.AddRectFilled({plot.low.x, y}, plot.high, faded(palette().good, 0.07F));
  for (float x = plot.low.x; x < plot.high.x; x += scaled(8))
    list.AddLine({x, y}, {std::min(x + scaled(4), plot.high.x), y}, faded(palette().good, 0.7F));
  const std::string text = fmt::format("target {:.3g}", target);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float text_y = y - size.y - scaled(2) > plot.low.y ? y - size.y - scaled(2) : y + scaled(2);
  list.AddText({std::round(plot.high.x - size.x - scaled(5)), std::round(text_y)},
               faded(palette().good, 0.85F), text.c_str());
}

void draw_front(ImDrawList& list, const AccuracyPlot& plot, std::span<const WorkPrecision> front) {
  if (front.empty()) return;
  std::vector<ImVec2> stairs{{plot.place(front.front()).x, plot.low.y}};
  for (const WorkPrecision& point : front) {
    const ImVec2 at = plot.place(point);
    stairs.push_back({at.x, stairs.back().y});
    stairs.push_back(at);
  }
  stairs.push_back({plot.high.x, stairs.back().y});
  list.AddPolyline(stairs.data(), int(stairs.size()), faded(palette().curve, 0.2F), ImDrawFlags_None,
                   scaled(5));
}

void draw_line(ImDrawList& list, const AccuracyPlot& plot, const MethodLine& line, double target, float alpha,
               bool emphasized) {
  std::vector<ImVec2> places;
  for (const AnswerPoint& p : line.points) places.push_back(plot.place(p.point));
  list.AddPolyline(places.data(), int(places.size()), faded(color_of(*line.method), 0.85F * alpha),
                   ImDrawFlags_None, scaled(emphasized ? 2.6F : 1.4F));
  for (std::size_t i = 0; i < places.size(); ++i)
    draw_mark(list, places[i], scaled(emphasized ? 4.6F : 3.8F), *line.method,
              line.points[i].point.error <= target, alpha);
}

void draw_ring(ImDrawList& list, const AccuracyPlot& plot, WorkPrecision point, float radius, ImU32 color,
               const char* word, bool word_on_the_left) {
  const ImVec2 at = plot.place(point);
  list.AddCircle(at, radius, color, 24, scaled(1.8F));
  const ImVec2 size = ImGui::CalcTextSize(word);
  const float gap = radius + scaled(4), left = at.x - gap - size.x, right = at.x + gap;
  const bool on_the_left = word_on_the_left ? left > plot.low.x : right + size.x > plot.high.x;
  const ImVec2 corner{std::round(on_the_left ? left : right), std::round(at.y - size.y / 2)};
  list.AddRectFilled({corner.x - scaled(2), corner.y}, {corner.x + size.x + scaled(2), corner.y + size.y},
                     faded(palette().plot, 0.75F), scaled(3));
  list.AddText(corner, color, word);
}

}  // namespace crest
