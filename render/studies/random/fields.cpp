#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/studies/random/kinds.h"

namespace crest {
namespace {

/// A value at a place in the box, of 0 to 1 on each axis.
using Formula = std::function<double(glm::dvec3 place)>;

Grid random_grid(Dice& dice) {
  Grid grid;
  for (int axis = 0; axis < 3; ++axis) grid.dims[axis] = 16 + dice.one_of(25);
  grid.spacing = glm::dvec3(dice.pick({1.0, 0.015625, 64.0}));
  grid.origin = grid.spacing * dice.vector(-20, 20);
  return grid;
}

glm::dvec3 place_of(const Grid& grid, int i, int j, int k) {
  return glm::dvec3(i, j, k) / glm::dvec3(grid.dims - 1);
}

std::shared_ptr<const Volume> volume_of(std::string_view name, const Grid& grid, const Formula& formula) {
  Volume volume;
  volume.name = name;
  volume.grid = grid;
  std::vector<float> values;
  values.reserve(grid.point_count());
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) values.push_back(float(formula(place_of(grid, i, j, k))));
  volume.values = std::move(values);
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

/// A formula of about -1 to 1 in a unit of its own. Values are multiples of 2^-16 of it, so that another
/// machine's sine makes the same ones.
std::shared_ptr<const Volume> scaled_volume(Dice& dice, std::string_view name, const Grid& grid,
                                            const Formula& formula) {
  const double scale = dice.pick({1.0, 256.0, 4096.0, 0.0009765625}),
               offset = scale * dice.pick({0.0, 0.0, -1.0, 8.0});
  return volume_of(name, grid, [&](glm::dvec3 place) {
    return offset + scale * (std::round(formula(place) * 65536) / 65536);
  });
}

std::shared_ptr<const Volume> noise(Dice& dice) {
  return scaled_volume(dice, "noise", random_grid(dice), [&](glm::dvec3) { return dice.between(-1, 1); });
}

Formula sum_of_waves(Dice& dice) {
  struct Wave {
    glm::dvec3 frequency;
    double phase, height;
  };
  std::array<Wave, 5> waves;
  for (Wave& wave : waves) wave = {dice.vector(-3, 3), dice.between(0, 1), dice.between(0.1, 0.4)};
  return [waves](glm::dvec3 place) {
    double sum = 0;
    for (const auto& [frequency, phase, height] : waves)
      sum += height * std::sin(2 * std::numbers::pi * (glm::dot(frequency, place) + phase));
    return sum;
  };
}

std::shared_ptr<const Volume> waves(Dice& dice) {
  const auto sum = sum_of_waves(dice);
  const Grid grid = random_grid(dice);
  return scaled_volume(dice, "waves", grid, sum);
}

std::shared_ptr<const Volume> stretched_waves(Dice& dice) {
  Grid grid = random_grid(dice);
  grid.spacing *= dice.vector(0.25, 4);
  const auto sum = sum_of_waves(dice);
  return scaled_volume(dice, "stretched waves", grid, sum);
}

/// Balls that fade towards their rims, some of them hollows.
std::shared_ptr<const Volume> shells(Dice& dice) {
  struct Ball {
    glm::dvec3 middle;
    double radius, height;
  };
  std::array<Ball, 5> balls;
  for (Ball& ball : balls) {
    ball = {dice.vector(0.1, 0.9), dice.between(0.2, 0.5), dice.pick({1.0, 0.6, -0.5})};
    ball.height *= dice.between(0.5, 1);
  }
  const Grid grid = random_grid(dice);
  return scaled_volume(dice, "shells", grid, [&](glm::dvec3 place) {
    double sum = 0;
    for (const auto& [middle, radius, height] : balls) {
      const double depth = 1 - glm::dot(place - middle, place - middle) / (radius * radius);
      if (depth > 0) sum += height * depth * depth;
    }
    return sum;
  });
}

/// One or two voxels thin, in a field that is constant.
std::shared_ptr<const Volume> tubes(Dice& dice) {
  struct Tube {
    glm::dvec3 through, along;
    double radius, height;
  };
  std::array<Tube, 9> tubes;
  for (Tube& tube : tubes)
    tube = {dice.vector(0.1, 0.9), dice.vector(-1, 1), dice.between(0.03, 0.09), dice.between(0.4, 1)};
  const Grid grid = random_grid(dice);
  return scaled_volume(dice, "tubes", grid, [&](glm::dvec3 place) {
    double highest = 0;
    for (const auto& [through, along, radius, height] : tubes) {
      const glm::dvec3 from = place - through;
      const double foot = glm::dot(from, along);
      const double distance2 = glm::dot(from, from) - foot * foot / glm::dot(along, along);
      highest = std::max(highest, height * (1 - distance2 / (radius * radius)));
    }
    return highest;
  });
}

/// The label of the nearest of some sites.
std::shared_ptr<const Volume> labels(Dice& dice) {
  constexpr int label_count = 5;
  const Grid grid = random_grid(dice);
  std::array<glm::dvec3, 14> sites;
  std::array<int, sites.size()> label_of;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    // Grid points, so that each label is there
    const int z = dice.one_of(grid.dims.z), y = dice.one_of(grid.dims.y), x = dice.one_of(grid.dims.x);
    sites[i] = place_of(grid, x, y, z);
    label_of[i] = i < label_count ? int(i) : dice.one_of(label_count);
  }
  return volume_of("labels", grid, [&](glm::dvec3 place) {
    std::size_t nearest = 0;
    const auto distance2 = [&](std::size_t i) { return glm::dot(place - sites[i], place - sites[i]); };
    for (std::size_t i = 1; i < sites.size(); ++i)
      if (distance2(i) < distance2(nearest)) nearest = i;
    return double(label_of[nearest]);
  });
}

}  // namespace

std::span<const FieldKind> field_kinds() {
  static constexpr FieldKind kinds[] = {
      {"noise", noise},   {"waves", waves}, {"stretched waves", stretched_waves},
      {"shells", shells}, {"tubes", tubes}, {"labels", labels, true}};
  return kinds;
}

}  // namespace crest
