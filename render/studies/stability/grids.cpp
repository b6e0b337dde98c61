#include <fmt/core.h>

#include <algorithm>

#include "presets/names.h"
#include "render/scene/camera.h"
#include "render/studies/stability/cases.h"
#include "render/studies/stability/haze_and_plane.h"

// The smallest grid, and long ones.

namespace crest::stability {
namespace {

std::vector<Row> rows_of(Lab& lab, const std::string& name, const HazeAndPlane& haze, const Camera& camera,
                         double bound = 1e-5) {
  std::vector<Row> rows;
  for (const Mode mode : tested_modes) {
    const Image image = lab.draw(scene_of(haze, mode), camera);
    const std::vector<bool> at_an_end = surface_at_an_end(haze, camera, lab.size);
    Worst worst;
    worst.take(largest_difference(image, truth_of(haze, mode, camera, lab.size), at_an_end), "");
    rows.push_back(judge({.name = fmt::format("{}, {}", name, crest::name_of(mode)),
                          .quantity = "largest error of a channel, haze with a surface in it",
                          .bound = bound},
                         worst, {&image, 1}, int(std::ranges::count(at_an_end, true))));
  }
  return rows;
}

void append(std::vector<Row>& rows, std::vector<Row> more) {
  std::ranges::move(more, std::back_inserter(rows));
}

/// Into the end of a box that is long in z, beside its axis.
Camera into_the_end(const Grid& grid) {
  const glm::dvec3 box = grid.box_size();
  Camera camera;
  camera.eye = {0.4 * box.x, 0.7 * box.y, -1.2 * box.x};
  camera.target = {0.5 * box.x, 0.45 * box.y, 0.3 * box.z};
  camera.up = {0, 1, 0};
  camera.fov_y_degrees = 40;
  return camera;
}

/// A piece of such a box, from its side.
Camera across(const Grid& grid) {
  const glm::dvec3 box = grid.box_size();
  Camera camera;
  camera.target = {0.5 * box.x, 0.5 * box.y, 0.5 * box.z};
  camera.eye = camera.target + glm::dvec3(-2.1, 0.9, 1.3) * box.x;
  camera.up = {0, 1, 0};
  camera.fov_y_degrees = 40;
  return camera;
}

}  // namespace

std::vector<Row> smallest_grid(Lab& lab) {
  const HazeAndPlane haze{.grid = cube(2), .unit_distance = 1};
  return rows_of(lab, "2x2x2 points", haze, whole_volume_camera(haze.grid, 1));
}

std::vector<Row> long_grid(Lab& lab) {
  HazeAndPlane haze{
      .grid = {{2, 2, 500}, glm::dvec3(1), glm::dvec3(0)}, .isovalue_share = 0.004, .unit_distance = 20};
  std::vector<Row> rows = rows_of(lab, "2x2x500 points, along", haze, into_the_end(haze.grid));
  haze.isovalue_share = 0.5;
  append(rows, rows_of(lab, "2x2x500 points, across", haze, across(haze.grid)));
  return rows;
}

std::vector<Row> long_spacing(Lab& lab) {
  constexpr double stretched = 1e-4;  // places are rounded to 1e-3 of the smallest spacing
  HazeAndPlane deep{
      .grid = {glm::ivec3(9), {1, 1, 1000}, glm::dvec3(0)}, .weights = {0, 0, 1}, .isovalue_share = 0.0125};
  Camera narrow = into_the_end(deep.grid);
  narrow.fov_y_degrees = 8;
  std::vector<Row> rows = rows_of(lab, "spacing 1:1:1000, along", deep, narrow, stretched);
  deep.weights = {1, 2, 4};
  deep.isovalue_share = 0.5;
  append(rows, rows_of(lab, "spacing 1:1:1000, across", deep, across(deep.grid), stretched));
  const HazeAndPlane flat{.grid = {glm::ivec3(9), {1000, 1000, 1}, glm::dvec3(0)}};
  append(rows, rows_of(lab, "spacing 1000:1000:1", flat, whole_volume_camera(flat.grid, 1), stretched));
  return rows;
}

}  // namespace crest::stability
