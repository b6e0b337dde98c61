#include "render/classify/tf_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crest {
namespace {

float float_below(double value) {
  const float nearest = float(value);
  return double(nearest) <= value ? nearest
                                  : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

/// Opaque at any length that a step can have; infinity would make 0 * infinity of a piece of no length.
constexpr double most_extinction = 1e30;

float float_above(double value) { return -float_below(-value); }

}  // namespace

TfTable build_tf_table(const TransferFunction& tf, ValueRange field, double smallest_spacing, int entries) {
  const ValueRange span = tf.span();
  TfTable table;
  table.range.min = float_below(std::clamp(span.min, field.min, field.max));
  table.range.max = float_above(std::clamp(span.max, field.min, field.max));
  if (!(table.range.width() > 0)) {
    // A constant field, or a TF beside the data: one material on either side
    const double size = std::max(std::abs(table.range.min), field.width());
    table.range.max =
        float_above(table.range.min + std::max(1e-6 * size, double(std::numeric_limits<float>::min())));
  }
  table.entries.resize(std::size_t(entries));
  for (int i = 0; i < entries; ++i) {
    const double value =
        i + 1 == entries ? table.range.max : table.range.min + table.range.width() * i / (entries - 1);
    const bool stands_for_all_below = i == 0 && field.min < table.range.min;
    const Classified material = stands_for_all_below ? evaluate_left(tf, value) : evaluate(tf, value);
    const double per_spacing = extinction(material.opacity, tf.unit_distance) * smallest_spacing;
    table.entries[std::size_t(i)] = glm::vec4(material.color, float(std::min(per_spacing, most_extinction)));
  }
  return table;
}

}  // namespace crest
