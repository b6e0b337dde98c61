#include "render/classify/antiderivatives.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "render/classify/mean_material.h"
#include "render/classify/tf_pieces.h"

namespace crest {
namespace {

/// A material per smallest spacing, no more than a table holds.
glm::dvec4 per_spacing(MeanMaterial material, double spacing) {
  return material * std::min(spacing, most_extinction / std::max(material.a, 1e-300));
}

/// Whether a line of this mean and slope is a material at both of its ends: neither negative nor brighter
/// than its extinction allows. The line from one end of a bin with a spike or a step to the other may not
/// be.
bool is_material(glm::dvec4 mean, glm::dvec4 slope) {
  const double rounding = 1e-6 * mean.a;
  for (const glm::dvec4 end : {mean - 0.5 * slope, mean + 0.5 * slope})
    for (int channel = 0; channel < 4; ++channel)
      if (end[channel] < -rounding || end[channel] > end.a + rounding) return false;
  return true;
}

}  // namespace

Antiderivatives build_antiderivatives(const TransferFunction& tf, ValueRange field, double smallest_spacing,
                                      int bins) {
  Antiderivatives result;
  result.range = table_range(pieces_of(tf, field));
  result.entries.reserve(std::size_t(bins) + 2);
  const double spacing = smallest_spacing / tf.unit_distance;
  glm::dvec4 sum(0);
  const auto add = [&](glm::dvec4 mean, glm::dvec4 slope) {
    const glm::vec4 high(sum);
    result.entries.push_back({glm::vec4(mean), glm::vec4(slope), high, glm::vec4(sum - glm::dvec4(high))});
    sum += mean;
  };
  const auto material_of = [&](const Classified& c) { return per_spacing(mean_material(c, c), spacing); };
  add(material_of(evaluate_right(tf, field.min)), glm::dvec4(0));
  const std::vector<MeanMaterial> means = mean_materials(tf, result.range, bins);
  const double width = result.range.width() / bins;
  for (std::size_t i = 0; i < means.size(); ++i) {
    const double begin = result.range.min + double(i) * width, end = result.range.min + double(i + 1) * width;
    const glm::dvec4 mean = per_spacing(means[i], spacing);
    const glm::dvec4 slope = material_of(evaluate_left(tf, end)) - material_of(evaluate_right(tf, begin));
    add(mean, is_material(mean, slope) ? slope : glm::dvec4(0));
  }
  add(material_of(evaluate(tf, field.max)), glm::dvec4(0));
  return result;
}

}  // namespace crest
