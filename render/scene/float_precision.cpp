#include "render/scene/float_precision.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "presets/choices.h"
#include "presets/peaks.h"
#include "render/scene/camera.h"

namespace crest {
namespace {

/// A step of an 8-bit picture. What haze_rounding() says is met only where something is seen through about a
/// mean free path of the densest material: a quarter of it would be a false alarm in each large, opaque
/// volume.
constexpr double visible = 1.0 / 255;

/// Fewer numbers than an 8-bit file has.
constexpr double few_levels = 256;

/// A pixel's width, in roundings of a position, below which edges are seen to be off.
constexpr double few_roundings = 8;

double diagonal(const Grid& grid) { return glm::length(grid.box_size()); }

/// Greatest opacity of one unit distance that a value in the range has. A spike of no width is of no length.
double greatest_opacity(const TransferFunction& tf, ValueRange range) {
  double greatest = std::max(evaluate(tf, range.min).opacity, evaluate(tf, range.max).opacity);
  for (const ControlPoint& point : tf.points) {
    if (point.value < range.min || point.value > range.max) continue;
    greatest = std::max(greatest, evaluate(tf, point.value).opacity);
    if (point.value > range.min) greatest = std::max(greatest, evaluate_left(tf, point.value).opacity);
  }
  return greatest;
}

/// What DVR samples: in PEAK_XOR_DVR's split form, the TF without its spikes.
TransferFunction dvr_tf(const Scene& scene) {
  return takes_base_tf(scene.rendering) ? base_transfer_function(scene.tf, find_peaks(scene.tf)) : scene.tf;
}

/// The spacing of the float32 numbers at a range's end that is further from zero.
double float_spacing(ValueRange range) {
  const float furthest = float(std::max(std::abs(range.min), std::abs(range.max)));
  return double(std::nextafter(furthest, std::numeric_limits<float>::infinity())) - double(furthest);
}

/// Whether a file's type has numbers in the range that float32 has not.
bool loses_digits(ScalarType type, ValueRange range) {
  if (type == ScalarType::float64) return true;
  return size_of(type) >= 4 && type != ScalarType::float32 && float_spacing(range) > 1;
}

}  // namespace

double haze_rounding(const Scene& scene) {
  if (!shows_dvr(scene.rendering.mode)) return 0;
  const double opacity = greatest_opacity(dvr_tf(scene), dvr_range(scene));
  return 4 * 0x1p-24 * extinction(opacity, scene.tf.unit_distance) * diagonal(scene.volume->grid);
}

double pixel_roundings(const Grid& grid, const Camera& camera, glm::ivec2 size) {
  const double distance =
      std::max(glm::length(grid.origin + 0.5 * grid.box_size() - camera.eye), 0.5 * diagonal(grid));
  const double pixel = 2 * half_height(camera)(distance) / size.y;
  return pixel / (0x1p-24 * diagonal(grid));
}

std::vector<std::string> volume_warnings(const Volume& volume) {
  const ValueRange range = volume.statistics.range;
  const double levels = range.width() / float_spacing(range);
  if (!loses_digits(volume.file_type, range) || levels == 0 || levels >= few_levels) return {};
  return {fmt::format(
      "The volume's values lie so far from zero that its range holds only {:.0f} numbers of 32-bit "
      "float: an offset taken off in the file would keep its {} digits.",
      levels, name_of(volume.file_type))};
}

std::vector<std::string> scene_warnings(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  std::vector<std::string> warnings = volume_warnings(*scene.volume);
  if (const double off = haze_rounding(scene); off > visible)
    warnings.push_back(fmt::format(
        "The densest material absorbs so much within the rounding of a position that a pixel may be "
        "off by {:.2g}: a unit distance {:.2g} times as long would keep it below what is seen.",
        std::min(off, 1.0), off / visible));
  if (const double roundings = pixel_roundings(scene.volume->grid, camera, size); roundings < few_roundings)
    warnings.push_back(fmt::format(
        "A pixel is only {:.2g} roundings of a position wide: edges may be drawn a pixel off.", roundings));
  return warnings;
}

}  // namespace crest
