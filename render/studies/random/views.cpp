#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/studies/random/kinds.h"

namespace crest {
namespace {

glm::dvec3 middle_of(const Grid& grid) { return grid.origin + 0.5 * grid.box_size(); }

glm::dvec3 random_direction(Dice& dice) {
  for (;;) {
    const glm::dvec3 v = dice.vector(-1, 1);
    const double squared = glm::dot(v, v);
    if (squared > 0.01 && squared <= 1) return v / std::sqrt(squared);
  }
}

Camera looking(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up, double fov_y_degrees) {
  return {eye, target, up, fov_y_degrees, Projection::perspective, {}};
}

/// From so far that the rays are parallel in effect; the picture is `height` high.
Camera far_away(const Grid& grid, glm::dvec3 from, glm::dvec3 up, double height) {
  const double distance = 1e4 * height;
  return looking(middle_of(grid) + distance * from, middle_of(grid), up,
                 glm::degrees(2 * std::atan(0.5 * height / distance)));
}

glm::dvec3 unit(int axis) {
  glm::dvec3 v(0);
  v[axis] = 1;
  return v;
}

Camera outside(Dice& dice, const Grid& grid) {
  const double away = dice.between(1.1, 1.6) * glm::length(grid.box_size());
  const glm::dvec3 direction = random_direction(dice), up = random_direction(dice);
  return looking(middle_of(grid) + away * direction, middle_of(grid), up, 36);
}

Camera inside(Dice& dice, const Grid& grid) {
  const glm::dvec3 eye = grid.origin + dice.vector(0.2, 0.8) * grid.box_size(),
                   target = grid.origin + dice.vector(0, 1) * grid.box_size();
  const double fov_y_degrees = dice.pick({60.0, 90.0});
  return looking(eye, target, random_direction(dice), fov_y_degrees);
}

/// The eye lies in a face's plane, and looks along it.
Camera grazing(Dice& dice, const Grid& grid) {
  const int axis = dice.one_of(3), along = (axis + 1) % 3, across = (axis + 2) % 3;
  const bool far_side = dice.one_in(2);
  glm::dvec3 target = middle_of(grid), eye = target;
  target[axis] = eye[axis] = (far_side ? grid.box_max() : grid.box_min())[axis];
  eye[along] -= dice.between(0.7, 1.1) * grid.box_size()[along];
  eye[across] += dice.between(-0.4, 0.4) * grid.box_size()[across];
  return looking(eye, target, unit(axis), 50);
}

Camera along_an_axis(Dice& dice, const Grid& grid) {
  const int axis = dice.one_of(3);
  const double side = dice.pick({-1.0, 1.0}), height = 1.1 * grid.box_size()[(axis + 1) % 3];
  return far_away(grid, side * unit(axis), unit((axis + 1) % 3), height);
}

Camera parallel(Dice& dice, const Grid& grid) {
  const glm::dvec3 from = random_direction(dice), up = random_direction(dice);
  Camera camera = far_away(grid, from, up, 0.9 * glm::length(grid.box_size()));
  camera.projection = Projection::parallel;
  return camera;
}

/// Close before a corner, with a wide view.
Camera at_a_corner(Dice& dice, const Grid& grid) {
  glm::dvec3 corner;
  for (int axis = 0; axis < 3; ++axis) corner[axis] = dice.pick({-0.52, 0.52});
  return looking(middle_of(grid) + corner * grid.box_size(), middle_of(grid), random_direction(dice), 80);
}

}  // namespace

std::span<const ViewKind> view_kinds() {
  static constexpr ViewKind kinds[] = {{"outside", outside},        {"inside", inside},
                                       {"along a face", grazing},   {"along an axis", along_an_axis},
                                       {"parallel rays", parallel}, {"at a corner", at_a_corner}};
  return kinds;
}

}  // namespace crest
