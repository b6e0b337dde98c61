#include "presets/exchange/vtk_model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "presets/exchange/table.h"

namespace crest {
namespace {

/// Entries of VTK's opacity table (vtkOpenGLVolumeLookupTable, EstimateMinNumberOfSamples).
int vtk_entries(const std::vector<double>& values, ValueRange range) {
  double smallest_gap = range.width();
  for (std::size_t i = 1; i < values.size(); ++i)
    smallest_gap = std::min(smallest_gap, values[i] - values[i - 1]);
  const double wanted = std::min(range.width() / std::max(smallest_gap, 1e-300), 16384.0);
  return std::clamp(int(std::bit_ceil(unsigned(std::ceil(wanted)))), 1024, 16384);
}

}  // namespace

ValueRange range_there(const ExportInput& input) {
  return with_width(input.volume ? input.volume->range : input.preset.transfer_function.range());
}

TransferFunction tabled(const TransferFunction& original, const std::vector<double>& values, ValueRange range,
                        int entries) {
  TransferFunction tf = original;
  for (std::size_t i = 0; i < values.size(); ++i) tf.points[i].value = values[i];
  TransferFunction result = tf;
  result.points.clear();
  const auto value_of = [&](int entry) {
    return std::lerp(range.min, range.max, double(entry) / (entries - 1));
  };
  const auto add = [&](int entry) {
    const double value = value_of(entry);
    if (!result.points.empty() && result.points.back().value >= value) return;
    const auto [color, opacity] = evaluate(tf, value);
    result.points.push_back(
        {.value = value, .color = color, .opacity = opacity, .surface = {}, .unknown = {}});
  };
  // Between points the table is as linear as the TF: the entries about each point are all that bend
  add(0);
  for (const ControlPoint& point : tf.points) {
    const double place = (point.value - range.min) / range.width() * (entries - 1);
    if (!(place > -1 && place < entries)) continue;
    const int below = int(std::floor(place));
    for (int entry = below - 1; entry <= below + 2; ++entry)
      if (entry >= 0 && entry < entries) add(entry);
  }
  add(entries - 1);
  return result;
}

Preset in_vtk_settings(Preset drawn) {
  Rendering& r = drawn.rendering;
  r.mode = Mode::dvr_only;
  r.engine = Engine::raycaster;
  r.classification = ClassificationMethod::post;
  r.sampling = Sampling::uniform;
  r.adaptive = false;
  r.step = 1;
  r.placement = Placement::entry;
  r.filter = Filter::linear;
  r.root_filter.reset();
  r.blend_mode = BlendMode::semi_transparent;
  r.early_termination = 1.0 / 255;
  r.clip_box.reset();
  return drawn;
}

Preset drawn_by_vtk(const ExportInput& input, const std::vector<double>& values, double unit_distance) {
  Preset drawn = in_vtk_settings(input.preset);
  TransferFunction& tf = drawn.transfer_function;
  tf.unit_distance = unit_distance;
  const ValueRange range = range_there(input);
  tf = tabled(tf, values, range, vtk_entries(values, range));
  return drawn;
}

Preset drawn_by_vtk_with_contours(const ExportInput& input, const ShownContributions& shown,
                                  const std::vector<double>& values) {
  ExportInput dvr = input;
  dvr.preset.transfer_function = shown.dvr;
  Preset drawn = drawn_by_vtk(dvr, values, shown.dvr.unit_distance);
  if (shown.surfaces.empty()) return drawn;
  TransferFunction& tf = drawn.transfer_function;
  for (ControlPoint& point : tf.points) point.surface.mode = SurfaceMode::off;
  // A surface is a point that is switched on: on the curve, with its own colour for an instant
  const double instant = 1e-9 * range_there(input).width();
  for (const Peak& peak : shown.surfaces) {
    std::vector<ControlPoint> points;
    for (const double value : {peak.value - instant, peak.value, peak.value + instant}) {
      const auto [color, opacity] = evaluate(tf, value);
      points.push_back({.value = value,
                        .color = color,
                        .opacity = opacity,
                        .surface = {SurfaceMode::off, {}},
                        .unknown = {}});
    }
    points[1].color = peak.color;
    points[1].surface = {SurfaceMode::on, peak.opacity};
    const auto place = std::ranges::upper_bound(tf.points, peak.value, {}, &ControlPoint::value);
    tf.points.insert(place, points.begin(), points.end());
  }
  std::ranges::stable_sort(tf.points, {}, &ControlPoint::value);
  drawn.rendering.mode = shown.shows_dvr ? Mode::both : Mode::peak_only;
  return drawn;
}

}  // namespace crest
