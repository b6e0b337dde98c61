#include "render/raycaster/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

namespace crest {
namespace {

/// What the eye begins to see: a quarter of a step of an 8-bit picture.
constexpr double visible = 1e-3;

/// Fewer numbers than an 8-bit file has.
constexpr double few_levels = 256;

double diagonal(const Grid& grid) { return glm::length(grid.box_size()); }

/// Greatest opacity of one unit distance that a value in the range has.
double greatest_opacity(const TransferFunction& tf, ValueRange range) {
  double greatest = std::max(evaluate(tf, range.min).opacity, evaluate_left(tf, range.max).opacity);
  for (const ControlPoint& point : tf.points)
    if (point.value >= range.min && point.value <= range.max) greatest = std::max(greatest, point.opacity);
  return greatest;
}

/// Whether a file's type holds numbers that float32 does not.
bool is_wider_than_float(ScalarType type) { return size_of(type) >= 4 && type != ScalarType::float32; }

/// How many float32 numbers there are in a range, at its end that is further from zero.
double levels_of(ValueRange range) {
  const float furthest = float(std::max(std::abs(range.min), std::abs(range.max)));
  const double spacing =
      double(std::nextafter(furthest, std::numeric_limits<float>::infinity())) - double(furthest);
  return range.width() / spacing;
}

}  // namespace

double haze_rounding(const Scene& scene) {
  if (scene.rendering.mode == Mode::peak_only) return 0;
  const double opacity = greatest_opacity(scene.tf, dvr_range(scene));
  return 4 * 0x1p-24 * extinction(opacity, scene.tf.unit_distance) * diagonal(scene.volume->grid);
}

double pixel_roundings(const Grid& grid, const Camera& camera, glm::ivec2 size) {
  const double distance = glm::length(grid.origin + 0.5 * grid.box_size() - camera.eye);
  const double pixel = 2 * std::tan(glm::radians(0.5 * camera.fov_y_degrees)) / size.y * distance;
  return pixel / (0x1p-24 * diagonal(grid));
}

std::vector<std::string> scene_warnings(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  std::vector<std::string> warnings;
  const Volume& volume = *scene.volume;
  if (const double off = haze_rounding(scene); off > visible)
    warnings.push_back(
        fmt::format("The densest material absorbs so much within the rounding of a position that a pixel may "
                    "be off by {:.2g}: "
                    "a unit distance {:.2g} times as long would keep it below what is seen.",
                    std::min(off, 1.0), off / visible));
  if (const double levels = levels_of(volume.statistics.range);
      is_wider_than_float(volume.file_type) && volume.statistics.range.width() > 0 && levels < few_levels)
    warnings.push_back(
        fmt::format("The volume's values lie so far from zero that its range holds only {:.0f} numbers of "
                    "32-bit float: an offset "
                    "taken off in the file would keep its {} digits.",
                    levels, name_of(volume.file_type)));
  if (const double roundings = pixel_roundings(volume.grid, camera, size); roundings < 8)
    warnings.push_back(fmt::format(
        "A pixel is only {:.2g} roundings of a position wide: edges may be drawn a pixel off.", roundings));
  return warnings;
}

}  // namespace crest
