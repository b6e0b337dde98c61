#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "presets/names.h"
#include "render/scene/camera.h"
#include "render/studies/stability/cases.h"
#include "render/studies/stability/views.h"

// Two pictures that differ by nothing but the words in which the scene is told.

namespace crest::stability {
namespace {

View with_world(const View& view, double scale, glm::dvec3 shift) {
  View changed = view;
  Volume volume = *view.scene.volume;
  volume.grid.spacing *= scale;
  volume.grid.origin = volume.grid.origin * scale + shift;
  changed.scene.volume = std::make_shared<const Volume>(std::move(volume));
  changed.scene.tf.unit_distance *= scale;
  changed.camera.eye = view.camera.eye * scale + shift;
  changed.camera.target = view.camera.target * scale + shift;
  return changed;
}

/// Each line of the TF is told in two: a point at `share` of it.
View with_inserted_points(const View& view, double share) {
  View changed = view;
  auto& points = changed.scene.tf.points;
  points.clear();
  for (const ControlPoint& next : view.scene.tf.points) {
    if (!points.empty()) {
      const ControlPoint last = points.back();
      points.push_back(point(std::lerp(last.value, next.value, share),
                             std::lerp(last.opacity, next.opacity, share),
                             last.color + share * (next.color - last.color)));
    }
    points.push_back(next);
  }
  return changed;
}

/// Axis a of the new world is axis `from[a]` of the old one, backwards where `backwards[a]`.
View with_axes(const View& view, std::array<int, 3> from, std::array<bool, 3> backwards) {
  const Volume& old = *view.scene.volume;
  const auto turned = [&](glm::dvec3 v) { return glm::dvec3(v[from[0]], v[from[1]], v[from[2]]); };
  Volume volume = old;
  volume.grid.dims = glm::ivec3(turned(glm::dvec3(old.grid.dims)));
  volume.grid.spacing = turned(old.grid.spacing);
  volume.grid.origin = turned(old.grid.origin);
  const glm::ivec3 dims = volume.grid.dims;
  std::size_t next = 0;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) {
        const glm::ivec3 index(i, j, k);
        glm::ivec3 source;
        for (int a = 0; a < 3; ++a)
          source[from[std::size_t(a)]] = backwards[std::size_t(a)] ? dims[a] - 1 - index[a] : index[a];
        volume.values.floats()[next++] = old.at(source.x, source.y, source.z);
      }
  const glm::dvec3 middle = volume.grid.origin + 0.5 * volume.grid.box_size();
  const auto placed = [&](glm::dvec3 v, glm::dvec3 centre) {
    glm::dvec3 result = turned(v);
    for (int a = 0; a < 3; ++a)
      if (backwards[std::size_t(a)]) result[a] = 2 * centre[a] - result[a];
    return result;
  };
  View changed = view;
  changed.scene.volume = std::make_shared<const Volume>(std::move(volume));
  changed.camera.eye = placed(view.camera.eye, middle);
  changed.camera.target = placed(view.camera.target, middle);
  changed.camera.up = placed(view.camera.up, glm::dvec3(0));
  return changed;
}

}  // namespace

std::vector<Row> values_scaled_and_shifted(Lab& lab) {
  std::vector<Change> changes;
  for (const auto& [scale, shift] :
       {std::pair(5.0, 100.0), {-3.0, 50.0}, {1e4, -12345.0}, {1.0 / 1024, 3.0}, {1.0, 5000.0}})
    changes.push_back({fmt::format("{:g} v + {:g}", scale, shift),
                       [=](const View& view) { return with_values(view, scale, shift); }});
  return rows_of_changes(lab, "values scaled and shifted with the TF", plain_view, changes);
}

std::vector<Row> world_scaled(Lab& lab) {
  std::vector<Change> changes;
  for (const double scale : {1e-20, 1e-9, 7.3, 1e6, 1e20})
    changes.push_back({fmt::format("{:g} times as large", scale),
                       [=](const View& view) { return with_world(view, scale, glm::dvec3(0)); }});
  changes.push_back({"moved by 1000 boxes",
                     [](const View& view) { return with_world(view, 1, glm::dvec3(2000, -1000, 500)); }});
  return rows_of_changes(lab, "world scaled with the unit distance", plain_view, changes);
}

std::vector<Row> point_on_a_line(Lab& lab) {
  std::vector<Change> changes;
  for (const double share : {0.5, 0.1, 0.999})
    changes.push_back({fmt::format("at {:g} of each line", share),
                       [=](const View& view) { return with_inserted_points(view, share); }});
  return rows_of_changes(lab, "a point inserted on each line", plain_view, changes);
}

std::vector<Row> mirrored(Lab& lab) {
  std::vector<Change> changes;
  for (std::size_t axis = 0; axis < 3; ++axis)
    changes.push_back({fmt::format("{} mirrored", "xyz"[axis]),
                       [=](const View& view) {
                         std::array<bool, 3> backwards{};
                         backwards[axis] = true;
                         return with_axes(view, {0, 1, 2}, backwards);
                       },
                       true});
  changes.push_back({"x, y, z turned to y, z, x", [](const View& view) {
                       return with_axes(view, {1, 2, 0}, {});
                     }});
  return rows_of_changes(lab, "mirrored volume and camera", plain_view, changes);
}

}  // namespace crest::stability
