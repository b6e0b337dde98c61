#include "presets/exchange/vtk_model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "presets/exchange/table.h"

namespace crest {
namespace {

/// Entries of VTK's opacity table (vtkOpenGLVolumeLookupTable, EstimateMinNumberOfSamples).
int vtk_entries(const TransferFunction& tf, ValueRange range) {
  double smallest_gap = range.width();
  for (std::size_t i = 1; i < tf.points.size(); ++i)
    smallest_gap = std::min(smallest_gap, tf.points[i].value - tf.points[i - 1].value);
  const double wanted = std::min(range.width() / std::max(smallest_gap, 1e-300), 16384.0);
  return std::clamp(int(std::bit_ceil(unsigned(std::ceil(wanted)))), 1024, 16384);
}

}  // namespace

TransferFunction tabled(const TransferFunction& tf, ValueRange range, int entries) {
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

Preset drawn_by_vtk(const ExportInput& input, const std::vector<double>& values, double unit_distance) {
  Preset drawn = input.preset;
  TransferFunction& tf = drawn.transfer_function;
  for (std::size_t i = 0; i < values.size(); ++i) tf.points[i].value = values[i];
  tf.unit_distance = unit_distance;
  ValueRange range = input.volume ? input.volume->range : tf.range();
  if (!(range.width() > 0)) range.max = range.min + 1;
  tf = tabled(tf, range, vtk_entries(tf, range));
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

}  // namespace crest
