#include "render/volume/fit_values.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "presets/error.h"
#include "render/volume/match_values.h"

namespace crest {
namespace {

constexpr int fine_bins = 65536;

/// What the voxels of one value of the first volume have, or of several that were pooled.
struct Block {
  double count = 0, from = 0, to = 0;  ///< sums, the last of deviations from the other volume's mean
  double first = 0, last = 0;          ///< means of the first and the last bin's values
  double mean() const { return to / count; }
};

struct Joint {
  std::vector<Block> bins;  ///< those with voxels, by value
  double mean = 0;          ///< of the second volume, where the first has values
  double sum_of_squares = 0;
};

template <class Use>
void for_each_pair(const Volume& from, const Volume& to, Use use) {
  for (std::size_t i = 0; i < from.values.size(); ++i)
    if (std::isfinite(from.values[i]) && std::isfinite(to.values[i]))
      use(double(from.values[i]), double(to.values[i]));
}

Joint joint_of(const Volume& from, const Volume& to) {
  Joint joint;
  double count = 0;
  for_each_pair(from, to, [&](double, double y) { joint.mean += y, ++count; });
  if (count == 0) throw Error("no voxel has a value in both volumes");
  joint.mean /= count;
  const ValueRange range = with_width(from.statistics.range);
  joint.bins.resize(fine_bins);
  for_each_pair(from, to, [&](double x, double y) {
    const double place = (x - range.min) / range.width() * fine_bins;
    Block& bin = joint.bins[std::size_t(std::clamp(int(place), 0, fine_bins - 1))];
    ++bin.count;
    bin.from += x;
    bin.to += y - joint.mean;
    joint.sum_of_squares += (y - joint.mean) * (y - joint.mean);
  });
  std::erase_if(joint.bins, [](const Block& bin) { return bin.count == 0; });
  for (Block& bin : joint.bins) bin.first = bin.last = bin.from / bin.count;
  return joint;
}

/// Pools neighbours until the means ascend.
std::vector<Block> pooled(const std::vector<Block>& bins) {
  std::vector<Block> blocks;
  for (Block next : bins) {
    while (!blocks.empty() && blocks.back().mean() >= next.mean()) {
      const Block& before = blocks.back();
      next.count += before.count;
      next.from += before.from;
      next.to += before.to;
      next.first = before.first;
      blocks.pop_back();
    }
    blocks.push_back(next);
  }
  return blocks;
}

/// Of the variance, times the voxels: what lies between blocks.
double explained_by(const std::vector<Block>& blocks) {
  double sum = 0;
  for (const Block& block : blocks) sum += block.to * block.mean();
  return sum;
}

std::vector<Block> negated(std::vector<Block> bins) {
  for (Block& bin : bins) bin.to = -bin.to;
  return bins;
}

double width_ratio(const ValueFit& fit) {
  return with_width(fit.to_range).width() / with_width(fit.from_range).width();
}

/// Turned about: its values with the other sign, in the other order.
TransferFunction mirrored(TransferFunction tf) {
  std::ranges::reverse(tf.points);
  for (ControlPoint& point : tf.points) point.value = -point.value;
  return tf;
}

}  // namespace

ValueFit fit_values(const Volume& from, const Volume& to) {
  const glm::ivec3 a = from.grid.dims, b = to.grid.dims;
  if (a != b)
    throw Error(fmt::format("{} has {}x{}x{} points, and {} {}x{}x{}: place by place both need the same grid",
                            from.name, a.x, a.y, a.z, to.name, b.x, b.y, b.z));
  const Joint joint = joint_of(from, to);
  const std::vector<Block> up = pooled(joint.bins), down = pooled(negated(joint.bins));
  ValueFit fit;
  fit.is_decreasing = explained_by(down) > explained_by(up);
  fit.from_range = from.statistics.range;
  fit.to_range = to.statistics.range;
  const std::vector<Block>& blocks = fit.is_decreasing ? down : up;
  if (joint.sum_of_squares > 0)
    fit.explained = std::clamp(explained_by(blocks) / joint.sum_of_squares, 0.0, 1.0);
  for (const Block& block : blocks) {
    const double value = joint.mean + (fit.is_decreasing ? -block.mean() : block.mean());
    fit.from.push_back(block.first);
    fit.to.push_back(value);
    if (block.last == block.first) continue;
    fit.from.push_back(block.last);
    fit.to.push_back(value);
  }
  return fit;
}

double fitted_value(const ValueFit& fit, double value) {
  const double beyond = (fit.is_decreasing ? -1 : 1) * width_ratio(fit);
  if (value <= fit.from.front()) return fit.to.front() + (value - fit.from.front()) * beyond;
  if (value >= fit.from.back()) return fit.to.back() + (value - fit.from.back()) * beyond;
  const auto above = std::ranges::upper_bound(fit.from, value);
  const auto i = std::size_t(above - fit.from.begin());
  const double share = (value - fit.from[i - 1]) / (fit.from[i] - fit.from[i - 1]);
  return fit.to[i - 1] + (fit.to[i] - fit.to[i - 1]) * share;
}

TransferFunction carried(const TransferFunction& tf, const ValueFit& fit) {
  if (!fit.is_decreasing)
    return carried_by(
        tf, [&](double value) { return fitted_value(fit, value); }, width_ratio(fit));
  return mirrored(carried_by(
      tf, [&](double value) { return -fitted_value(fit, value); }, width_ratio(fit)));
}

}  // namespace crest
