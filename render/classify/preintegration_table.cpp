#include "render/classify/preintegration_table.h"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "presets/error.h"
#include "render/classify/mean_material.h"

namespace crest {
namespace {

/// What a ray collects where its values go through one bin or several in a row (Engel's slab), premultiplied,
/// for both ways along it: what it absorbs does not depend on the way.
struct Slab {
  glm::dvec3 rising{0}, falling{0};
  double transmittance = 1;
};

/// Of two slabs next to each other, `lower` that of the lower values.
Slab join(const Slab& lower, const Slab& upper) {
  return {lower.rising + lower.transmittance * upper.rising,
          upper.falling + upper.transmittance * lower.falling, lower.transmittance * upper.transmittance};
}

/// What one bin holds: its mean, and how much its colour rises over it.
struct Bin {
  MeanMaterial mean;
  glm::dvec3 rise{0};
};

glm::dvec3 color_of(MeanMaterial mean) { return glm::dvec3(mean) / std::max(mean.a, 1e-300); }

/// Of equal bins. The rise is that between the bin's ends, but no more than leaves colours about the mean.
std::vector<Bin> bins_of(const TransferFunction& tf, ValueRange range, int count) {
  std::vector<Bin> bins;
  bins.reserve(std::size_t(count));
  for (const MeanMaterial& mean : mean_materials(tf, range, count)) {
    const auto value = [&](double i) { return range.min + range.width() * i / count; };
    const double i = double(bins.size());
    const glm::dvec3 rise = evaluate_left(tf, value(i + 1)).color - evaluate_right(tf, value(i)).color;
    const glm::dvec3 most = 2.0 * glm::max(glm::min(color_of(mean), 1.0 - color_of(mean)), 0.0);
    bins.push_back({mean, glm::clamp(rise, -most, most)});
  }
  return bins;
}

/// A bin passed in this length, as if its extinction were even: what lies in front then hides what lies
/// behind by exp(-depth x), and of a colour that rises along x in [0, 1] by 1, more than the mean remains by
/// integral of (x - 1/2) depth exp(-depth x).
Slab slab_of(const Bin& bin, double length) {
  const double depth = bin.mean.a * length, alpha = -std::expm1(-depth);
  const double shift = depth < 1e-3 ? -depth * depth / 12 * (1 - depth / 2)
                                    : (alpha - depth * (1 - alpha)) / depth - alpha / 2;
  const glm::dvec3 color = alpha * color_of(bin.mean), shifted = shift * bin.rise;
  return {color + shifted, color - shifted, 1 - alpha};
}

/// All segments over `k` bins: from value i to value i + k and back.
void fill_diagonal(PreintegrationTable& table, const std::vector<Bin>& row, double length, std::size_t k) {
  const std::size_t bins = std::size_t(table.bins), slabs = row.size();
  // In blocks of k slabs: all of a block up to a slab, and all from it on
  std::vector<Slab> up_to(slabs), from(slabs);
  for (std::size_t i = 0; i < slabs; ++i) {
    const Slab slab = from[i] = slab_of(row[i], length / double(k));
    up_to[i] = i % k == 0 ? slab : join(up_to[i - 1], slab);
  }
  for (std::size_t i = slabs - 1; i-- > 0;)
    if ((i + 1) % k != 0) from[i] = join(from[i], from[i + 1]);
  for (std::size_t i = 0; i + k < bins; ++i) {
    const Slab whole = i % k == 0 ? up_to[i + k - 1] : join(from[i], up_to[i + k - 1]);
    const double alpha = 1 - whole.transmittance;
    table.entries[(i + k) * bins + i] = glm::vec4(whole.rising, alpha);
    table.entries[i * bins + i + k] = glm::vec4(whole.falling, alpha);
  }
}

}  // namespace

PreintegrationTable build_preintegration_table(const TransferFunction& tf, ValueRange field,
                                               double smallest_spacing, double length, int bins) {
  if (bins < 2 || bins > largest_preintegration_table)
    throw Error(fmt::format("the pre-integration table has 2 to {} bins, not {}",
                            largest_preintegration_table, bins));
  PreintegrationTable table{bins, field, length, {}};
  if (!(field.width() > 0)) table.range.max = field.min + std::max(1e-3 * std::abs(field.min), 1e-30);
  const std::size_t size = std::size_t(bins);
  table.entries.resize(size * size);
  const double unit_distances = length * smallest_spacing / tf.unit_distance;
  for (std::size_t i = 0; i < size; ++i) {
    const double value = i + 1 == size ? table.range.max
                                       : table.range.min + table.range.width() * double(i) / double(size - 1);
    const Classified material = i + 1 == size ? evaluate_left(tf, value) : evaluate(tf, value);
    const Slab slab = slab_of({mean_material(material, material)}, unit_distances);
    table.entries[i * size + i] = glm::vec4(slab.rising, 1 - slab.transmittance);
  }
  const std::vector<Bin> row = bins_of(tf, table.range, bins - 1);
  tbb::parallel_for(std::size_t(1), size,
                    [&](std::size_t k) { fill_diagonal(table, row, unit_distances, k); });
  return table;
}

}  // namespace crest
