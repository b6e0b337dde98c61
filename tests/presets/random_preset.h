#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <random>

#include "presets/preset.h"

namespace crest {

/// A preset with something in every field: numbers of all magnitudes, texts in need of escapes.
inline Preset random_preset(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto number = [&] { return (unit(random) - 0.5) * std::pow(10, int(random() % 60) - 30); };
  const auto vector = [&] { return glm::dvec3(number(), number(), number()); };
  const auto color = [&] { return glm::dvec3(unit(random), unit(random), random() % 2); };
  Preset preset;
  preset.name = "Ärger \"mit\" \\ Zeichen \n";
  preset.notes = random() % 2 ? "" : "\u2603 snow, tab\t";
  for (auto i = random() % 3; i > 0; --i) preset.tags.push_back(random() % 2 ? "CT" : "\u00e4 \"b\"");
  TransferFunction& tf = preset.transfer_function;
  tf.domain = random() % 2 ? Domain::data : Domain::normalized;
  tf.unit = random() % 2 ? LengthUnit::world : LengthUnit::voxel;
  tf.unit_distance = std::abs(number()) + 1e-30;
  tf.min_prominence = unit(random);
  tf.plateau_width = std::abs(number());
  tf.spike_width = random() % 2 ? 0.01 : unit(random);
  for (auto i = 1 + random() % 9; i > 0; --i) {
    ControlPoint point;
    point.value = random() % 3 ? number() : double(random() % 3);
    point.color = color();
    point.opacity = random() % 4 ? unit(random) : double(random() % 2);
    point.surface.mode = SurfaceMode(random() % 3);
    if (random() % 3 == 0) point.surface.opacity = unit(random);
    tf.points.push_back(point);
  }
  std::stable_sort(tf.points.begin(), tf.points.end(), [](auto& a, auto& b) { return a.value < b.value; });
  Rendering& rendering = preset.rendering;
  rendering.mode = Mode(random() % 4);
  rendering.peak_form = PeakForm(random() % 2);
  rendering.shading = Shading(random() % 2);
  rendering.step = random() % 2 ? 0.5 : unit(random) + 0.001;
  rendering.max_peaks = 1 + int(random() % 64);
  rendering.peak_bins = random() % 2 ? 128 : 1 + int(random() % 4096);
  rendering.placement = Placement(random() % 4);
  rendering.classification = ClassificationMethod(random() % 4);
  rendering.preintegration_bins = 2 + int(random() % 2047);
  rendering.sampling = Sampling(random() % 3);
  rendering.s_k = random() % 2 ? 4 : unit(random) + 0.001;
  rendering.adaptive = random() % 2;
  rendering.skipping = random() % 2;
  if (!why_inconsistent(rendering).empty()) {
    rendering.placement = Placement::entry;
    rendering.sampling = Sampling::uniform;
    rendering.adaptive = false;
  }
  if (random() % 2)
    rendering.vdls = {bool(random() % 2),     1 << (random() % 9), int(random() % 100), bool(random() % 2),
                      1 + int(random() % 64), bool(random() % 2),  bool(random() % 2)};
  rendering.filter = Filter(random() % 4);
  if (random() % 2) rendering.root_filter = Filter(random() % 4);
  if (!why_inconsistent(rendering).empty()) rendering = with_trilinear_filters(rendering);
  rendering.bc_b = unit(random) * 2;
  rendering.bc_c = unit(random) - 0.5;
  rendering.gradient = Gradient(random() % 2);
  if (random() % 2) {
    const glm::dvec3 a = vector(), b = vector();
    rendering.clip_box = ClipBox{glm::min(a, b), glm::max(a, b), random() % 2 ? "" : R"({"tilt":0.5})"};
  }
  rendering.early_termination = unit(random) / 100;
  rendering.background = color();
  if (random() % 2)
    preset.camera =
        Camera{vector(), vector(), vector(), 0.1 + 170 * unit(random), Projection(random() % 2), ""};
  return preset;
}

}  // namespace crest
