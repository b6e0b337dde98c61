#include "render/studies/stability/scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "presets/choices.h"
#include "render/volume/builtin.h"

namespace crest::stability {

Grid cube(int n) { return Grid{glm::ivec3(n), glm::dvec3(1), glm::dvec3(0)}; }

VolumePtr make_volume(const Grid& grid, std::vector<float> values) {
  Volume volume;
  volume.grid = grid;
  volume.name = "formula";
  volume.values = std::move(values);
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

VolumePtr make_volume(const Grid& grid, const std::function<double(glm::dvec3)>& formula) {
  std::vector<float> values;
  values.reserve(grid.point_count());
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        values.push_back(float(formula(grid.origin + grid.spacing * glm::dvec3(i, j, k))));
  return make_volume(grid, std::move(values));
}

ControlPoint point(double value, double opacity, glm::dvec3 color) {
  ControlPoint result;
  result.value = value;
  result.opacity = opacity;
  result.color = color;
  return result;
}

TransferFunction make_tf(std::vector<ControlPoint> points, double unit_distance) {
  TransferFunction tf;
  tf.points = std::move(points);
  tf.unit_distance = unit_distance;
  return tf;
}

TransferFunction peaks_at(const std::vector<double>& values, double opacity, double half_width) {
  std::vector<ControlPoint> points;
  for (const double value : values) {
    points.push_back(point(value - half_width, 0));
    points.push_back(point(value, opacity));
    points.push_back(point(value + half_width, 0));
  }
  return make_tf(std::move(points));
}

Scene make_scene(VolumePtr volume, TransferFunction tf, Mode mode, double step) {
  Scene scene;
  scene.volume = std::move(volume);
  scene.tf = std::move(tf);
  scene.rendering.mode = mode;
  scene.rendering.step = step;
  return scene;
}

Camera along_z(const Grid& grid, double extent) {
  Camera camera;
  const double distance = 1e5 * extent;
  camera.target = grid.origin + 0.5 * grid.box_size();
  camera.eye = camera.target - glm::dvec3(0, 0, distance);
  camera.up = {0, 1, 0};
  camera.fov_y_degrees = glm::degrees(2 * std::atan(0.5 * extent / distance));
  return camera;
}

VolumePtr gyroid_in_levels(int n) {
  Volume volume = make_builtin("gyroid?n=" + std::to_string(n));
  for (float& value : volume.values.floats()) value = std::round(value * 64) / 64;
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

TransferFunction haze_and_peaks(ValueRange range, double unit_distance) {
  const glm::dvec3 blue(0.2, 0.4, 1), red(1, 0.2, 0.1), yellow(1, 0.9, 0.3);
  return remap_values(
      make_tf({point(0, 0.02, blue), point(0.3, 0.1, blue), point(0.4, 0.5, red), point(0.5, 0.1, blue),
               point(0.7, 0.1, blue), point(0.7, 0.4, yellow), point(0.7, 0.1, blue), point(1, 0.2, blue)},
              unit_distance),
      {0, 1}, range);
}

TransferFunction haze_with_surface(ValueRange range, double isovalue, double haze_opacity,
                                   double surface_opacity, double unit_distance, Mode mode) {
  const glm::dvec3 blue(0, 0, 1), red(1, 0, 0);
  const ControlPoint haze = point(isovalue, haze_opacity, blue);
  std::vector<ControlPoint> points{point(range.min, haze_opacity, blue),
                                   point(range.max, haze_opacity, blue)};
  if (shows_surfaces(mode)) {
    ControlPoint surface = point(isovalue, surface_opacity, red);
    surface.surface.mode = SurfaceMode::on;  // it may be fainter than the haze
    points.insert(points.begin() + 1, {haze, surface, haze});
  }
  return make_tf(std::move(points), unit_distance);
}

}  // namespace crest::stability
