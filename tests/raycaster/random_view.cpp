#include "tests/raycaster/random_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render/scene/camera.h"
#include "render/studies/random/dice.h"

namespace crest::testing {
namespace {

/// Values of -1 to 1, and what they are scaled to.
float field_value(Dice& dice, int kind, glm::dvec3 place, glm::dvec3 waves) {
  const double smooth =
      std::sin(waves.x * place.x + std::cos(waves.y * place.y)) * std::cos(waves.z * place.z);
  switch (kind) {
    case 0:
      return float(dice.between(-1, 1));
    case 1:
      return float(std::round(4 * smooth) / 4);  // often exactly a peak's value
    case 2:
      return 0.25F;
    default:
      return float(smooth);
  }
}

std::shared_ptr<const Volume> random_volume(Dice& dice) {
  Volume volume;
  Grid& grid = volume.grid;
  grid.dims = {2 + dice.one_of(15), 2 + dice.one_of(15), 2 + dice.one_of(15)};
  grid.spacing = dice.one_in(2) ? glm::dvec3(1) : dice.vector(0.5, 2);
  grid.origin = dice.vector(-5, 5);
  const int kind = dice.one_of(6);
  const glm::dvec3 waves = dice.vector(0.1, 1);
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        volume.values.floats().push_back(field_value(dice, kind, {i, j, k}, waves));
  if (dice.one_in(3))
    for (int holes = 1 + dice.one_of(3); holes > 0; --holes)
      volume.values.floats()[std::size_t(dice.one_of(int(volume.values.size())))] =
          dice.one_in(2) ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
  volume.statistics = compute_statistics(grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

void add_point(TransferFunction& tf, Dice& dice, double value, double opacity) {
  ControlPoint point;
  point.value = value;
  point.opacity = opacity;
  point.color = dice.vector(0, 1);
  if (dice.one_in(8)) point.surface.mode = dice.pick({SurfaceMode::on, SurfaceMode::off});
  if (dice.one_in(8)) point.surface.opacity = dice.between(0, 1);
  tf.points.push_back(point);
}

/// Haze, with what stands out of it at random values, ascending.
TransferFunction random_tf(Dice& dice) {
  TransferFunction tf;
  tf.unit_distance = dice.pick({0.2, 1.0, 5.0});
  const double haze = dice.one_in(3) ? 0 : dice.between(0, 0.3), spread = dice.pick({1.0, 1.0, 1.0, 4.0});
  std::vector<double> places;
  for (int count = dice.pick({0, 1, 1, 2, 2, 3, 4, 4, 6, 9}); count > 0; --count)
    places.push_back(dice.one_in(3) ? 0.25 * (dice.one_of(9) - 4) : spread * dice.between(-1, 1));
  std::ranges::sort(places);
  places.erase(std::ranges::unique(places).begin(), places.end());
  add_point(tf, dice, -spread - 0.5, haze);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double room = i + 1 < places.size() ? places[i + 1] - places[i] : 0.5;
    const double width = dice.pick({0.0, 1e-4, 1e-2, 0.5}) * room, opacity = dice.pick({0.05, 0.5, 0.9, 1.0});
    if (tf.points.back().value < places[i] - width / 4) add_point(tf, dice, places[i] - width / 4, haze);
    add_point(tf, dice, places[i], opacity);
    if (dice.one_in(5)) add_point(tf, dice, places[i] + width / 8, opacity);
    add_point(tf, dice, places[i] + width / 4, dice.one_in(5) ? opacity / 2 : haze);
  }
  add_point(tf, dice, spread + 0.5, dice.one_in(3) ? 0.3 : haze);
  return tf;
}

ClipBox random_clip_box(Dice& dice, const Grid& grid) {
  const glm::dvec3 a = dice.vector(-0.2, 1.2), b = dice.vector(-0.2, 1.2);
  if (dice.one_in(4)) return {grid.box_min() - 1.0, grid.box_max() + 1.0, ""};
  return {grid.origin + glm::min(a, b) * grid.box_size(), grid.origin + glm::max(a, b) * grid.box_size(), ""};
}

Rendering random_rendering(Dice& dice, const Grid& grid) {
  Rendering rendering;
  rendering.mode = dice.pick({Mode::both, Mode::peak_xor_dvr, Mode::peak_only, Mode::dvr_only});
  rendering.peak_form = dice.pick({PeakForm::split, PeakForm::split, PeakForm::paper});
  rendering.step = dice.pick({0.1, 0.5, 1.0, 3.0});
  rendering.placement = dice.pick({Placement::entry_exit_corner, Placement::entry_exit_corner,
                                   Placement::entry_exit, Placement::entry, Placement::eye});
  rendering.sampling = dice.pick(
      {Sampling::uniform, Sampling::uniform, Sampling::uniform, Sampling::differential, Sampling::footprint});
  rendering.s_k = dice.pick({0.5, 2.0, 10.0});
  rendering.adaptive = dice.one_in(4);
  rendering.skipping = !dice.one_in(4);
  rendering.max_peaks = dice.pick({1, 4, 64});
  rendering.peak_bins = dice.pick({1, 16, 128});
  rendering.shading = dice.pick({Shading::none, Shading::none, Shading::gradient});
  rendering.filter = dice.pick(
      {Filter::linear, Filter::linear, Filter::linear, Filter::linear_exact, Filter::bspline, Filter::bc});
  if (dice.one_in(6)) rendering.root_filter = dice.pick({Filter::linear, Filter::bspline});
  rendering.gradient = dice.pick({Gradient::central, Gradient::filter});
  rendering.early_termination = dice.pick({0.0, 0.0, 0.01, 0.3});
  if (dice.one_in(3)) rendering.clip_box = random_clip_box(dice, grid);
  rendering.classification =
      dice.pick({ClassificationMethod::post, ClassificationMethod::post, ClassificationMethod::preintegrated,
                 ClassificationMethod::preintegrated_table, ClassificationMethod::analytic});
  rendering.preintegration_bins = dice.pick({2, 64});
  if (!why_inconsistent(rendering).empty()) rendering.classification = ClassificationMethod::preintegrated;
  return rendering;
}

Camera random_camera(Dice& dice, const Grid& grid) {
  Camera camera = whole_volume_camera(grid, 1);
  const glm::dvec3 middle = grid.origin + 0.5 * grid.box_size();
  const double size = glm::length(grid.box_size());
  if (dice.one_in(4)) return camera;
  camera.eye = middle + dice.pick({0.3, 1.0, 1.0, 2.0}) * size * dice.vector(-1, 1);
  camera.target = middle + dice.pick({0.0, 0.0, 0.2, 0.2, 0.2, 2.0}) * size * dice.vector(-1, 1);
  camera.up = dice.vector(-1, 1);
  camera.fov_y_degrees = dice.pick({10.0, 30.0, 60.0});
  return camera;
}

}  // namespace

View random_view(std::uint64_t seed) {
  Dice dice{Random(Random::mix(seed))};
  View view;
  view.scene.volume = random_volume(dice);
  view.scene.tf = random_tf(dice);
  view.scene.rendering = random_rendering(dice, view.scene.volume->grid);
  view.camera = random_camera(dice, view.scene.volume->grid);
  if (dice.one_in(4)) view.camera.projection = Projection::parallel;
  return view;
}

View analytic_view(std::uint64_t seed) {
  View view = random_view(seed);
  Rendering& r = view.scene.rendering;
  r.classification = ClassificationMethod::analytic;
  r.filter = Filter::linear;
  r.root_filter.reset();
  r.shading = Shading::none;
  r.early_termination = 0;
  return view;
}

}  // namespace crest::testing
