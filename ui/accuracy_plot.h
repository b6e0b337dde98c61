#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <vector>

#include "render/measure/methods.h"
#include "render/measure/pareto.h"

namespace crest {

/// A logarithmic axis over pixels.
struct LogAxis {
  double low = 1, high = 10;  ///< > 0
  float from = 0, to = 1;     ///< the pixels of both
  float place(double value) const;
};

/// A method's points against an exact answer, from the coarsest step to the finest.
struct MethodLine {
  const Method* method = nullptr;
  std::vector<AnswerPoint> points;
};
/// Of the methods that have any points, in the order of methods().
std::vector<MethodLine> method_lines(std::span<const Measurement> measured, const ExactAnswer& answer,
                                     const ErrorMeasure& measure);

/// The point of a step on a method's line: measured, or between its two neighbours. Nothing beyond the ends.
std::optional<WorkPrecision> point_at_step(const MethodLine& line, std::span<const Measurement> measured,
                                           double step);

/// The work-precision diagram: a frame's milliseconds across, the error up, both logarithmic.
struct AccuracyPlot {
  ImVec2 low, high;  ///< corners in pixels, low = top left
  LogAxis ms, error;
  bool has_zero = false;  ///< errors of 0 lie in a strip below the axis
  ImVec2 place(WorkPrecision point) const;
};

/// The axes that show all points and the target's error, in a box with its labels.
AccuracyPlot accuracy_plot(std::span<const MethodLine> lines, double target, ImVec2 low, ImVec2 high);

/// The point within reach of the mouse, the nearest one: an index into what was measured.
std::optional<std::size_t> point_near(const AccuracyPlot& plot, std::span<const MethodLine> lines,
                                      ImVec2 mouse);

ImU32 color_of(const Method& method);
/// A method's mark, filled where it meets the target.
void draw_mark(ImDrawList& list, ImVec2 at, float radius, const Method& method, bool filled, float alpha = 1);

/// Grid and labels.
void draw_axes(ImDrawList& list, const AccuracyPlot& plot);
/// The line that the target draws, and what lies under it.
void draw_target(ImDrawList& list, const AccuracyPlot& plot, double target);
/// The stairs of what no other setting beats, `front` in order of time.
void draw_front(ImDrawList& list, const AccuracyPlot& plot, std::span<const WorkPrecision> front);
void draw_line(ImDrawList& list, const AccuracyPlot& plot, const MethodLine& line, double target, float alpha,
               bool emphasized);
/// A ring about a point, with a word beside it.
void draw_ring(ImDrawList& list, const AccuracyPlot& plot, WorkPrecision point, float radius, ImU32 color,
               const char* word, bool word_on_the_left);

}  // namespace crest
