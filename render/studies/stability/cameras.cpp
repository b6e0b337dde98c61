#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "presets/names.h"
#include "render/scene/camera.h"
#include "render/studies/stability/cases.h"
#include "render/studies/stability/haze_and_plane.h"

// Where the eye may be, and how a ray may meet the box.

namespace crest::stability {
namespace {

Camera looking(glm::dvec3 eye, glm::dvec3 target, double fov_y_degrees = 30, glm::dvec3 up = {0, 1, 0}) {
  Camera camera;
  camera.eye = eye;
  camera.target = target;
  camera.up = up;
  camera.fov_y_degrees = fov_y_degrees;
  return camera;
}

/// One row a mode: the picture of haze with a surface in it.
std::vector<Row> rows_of(Lab& lab, const std::string& name, const Camera& camera, double bound = 1e-5,
                         const HazeAndPlane& haze = {}) {
  std::vector<Row> rows;
  const glm::ivec2 odd = lab.size + 1 - lab.size % 2;  // the middle pixel's ray goes to the target itself
  for (const Mode mode : tested_modes) {
    const Image image = lab.draw(scene_of(haze, mode), camera, odd);
    Worst worst;
    worst.take(largest_difference(image, truth_of(haze, mode, camera, odd)), "");
    rows.push_back(judge({.name = fmt::format("{}, {}", name, crest::name_of(mode)),
                          .quantity = "largest error of a channel, haze with a surface in it",
                          .bound = bound},
                         worst, {&image, 1}));
  }
  return rows;
}

void append(std::vector<Row>& rows, std::vector<Row> more) {
  std::ranges::move(more, std::back_inserter(rows));
}

}  // namespace

// The box of HazeAndPlane runs from 0 to 16; its surface is x + 2y + 4z = 50.4

std::vector<Row> eye_inside_the_volume(Lab& lab) {
  return rows_of(lab, "the eye inside the volume", looking({5.3, 4.1, 3.7}, {11, 9, 14}, 60));
}

std::vector<Row> eye_on_a_face(Lab& lab) {
  return rows_of(lab, "the eye on a face", looking({0, 6.5, 5.25}, {16, 9, 12}, 60));
}

std::vector<Row> eye_at_a_point(Lab& lab) {
  std::vector<Row> rows = rows_of(lab, "the eye at a grid point", looking({4, 5, 6}, {12, 9, 14}, 60));
  append(rows, rows_of(lab, "the eye at a corner", looking({0, 0, 0}, {8, 8, 8}, 60)));
  return rows;
}

std::vector<Row> eye_far_away(Lab& lab) {
  const double diagonal = std::sqrt(3.0) * 16, distance = 1e6 * diagonal;
  const glm::dvec3 middle(8), direction = glm::normalize(glm::dvec3(-0.45, 0.8, -0.4));
  return rows_of(lab, "the eye at 1e6 diagonals",
                 looking(middle + distance * direction, middle, glm::degrees(diagonal / distance)), 1e-4);
}

std::vector<Row> ray_along_an_axis(Lab& lab) {
  return rows_of(lab, "a ray along an axis", looking({7.3, 9.1, -30}, {7.3, 9.1, 0}, 40));
}

std::vector<Row> ray_in_a_face(Lab& lab) {
  // The middle column lies in the face x = 0, the middle ray along z
  return rows_of(lab, "rays in a face", looking({0, 8, -30}, {0, 8, 0}, 40));
}

std::vector<Row> ray_along_an_edge(Lab& lab) {
  return rows_of(lab, "a ray along an edge", looking({0, 0, -30}, {0, 0, 0}, 40));
}

std::vector<Row> ray_of_no_length(Lab& lab) {
  // The middle ray touches the box at the corner (0, 0, 0) alone
  return rows_of(lab, "a ray of no length at a corner", looking({12, -12, 0}, {0, 0, 0}, 40, {0, 0, 1}));
}

std::vector<Row> fields_of_view(Lab& lab) {
  const glm::dvec3 middle(8), away = glm::normalize(glm::dvec3(-0.45, 0.8, -0.4));
  const double height = 24;
  std::vector<Row> rows = rows_of(lab, "a field of view of 0.001 degrees",
                                  looking(middle + height / glm::radians(0.001) * away, middle, 0.001));
  append(rows, rows_of(lab, "a field of view of 170 degrees", looking({8.5, 7, -0.5}, middle, 170)));
  append(rows, rows_of(lab, "a field of view of 170 degrees from inside", looking({5, 6, 7}, middle, 170)));
  return rows;
}

std::vector<Row> up_along_the_view(Lab& lab) {
  std::vector<Row> rows;
  for (const glm::dvec3 direction : {glm::dvec3(0, 0, 1), glm::dvec3(1, 2, 3)})
    append(rows, rows_of(lab,
                         fmt::format("`up` along a view to ({:g}, {:g}, {:g})", direction.x, direction.y,
                                     direction.z),
                         looking(glm::dvec3(8) - 3.0 * direction * 4.0, glm::dvec3(8), 60, direction)));
  return rows;
}

}  // namespace crest::stability
