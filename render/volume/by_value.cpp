#include "render/volume/by_value.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>
#include <vector>

namespace crest {
namespace {

/// The values at four corners, ascending.
using Corners = std::array<double, 4>;

Corners sorted(Corners v) {
  const auto order = [&](std::size_t a, std::size_t b) {
    if (v[b] < v[a]) std::swap(v[a], v[b]);
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  return v;
}

double cube(double x) { return x * x * x; }

/// The share of a tetrahedron in which a linear field is below t. No term is negative, so that nothing
/// cancels where corners are nearly equal. Between the middle corners what lies below is a wedge, which is
/// three tetrahedra.
double share_below(const Corners& v, double t) {
  if (t <= v[0]) return 0;
  if (t >= v[3]) return 1;
  if (t < v[1]) return cube(t - v[0]) / ((v[1] - v[0]) * (v[2] - v[0]) * (v[3] - v[0]));
  if (t >= v[2]) return 1 - cube(v[3] - t) / ((v[3] - v[0]) * (v[3] - v[1]) * (v[3] - v[2]));
  const double p = (t - v[0]) / (v[2] - v[0]), q = (t - v[0]) / (v[3] - v[0]), r = (t - v[1]) / (v[2] - v[1]),
               s = (t - v[1]) / (v[3] - v[1]);
  return p * q * (1 - s) + p * s * (1 - r) + r * s;
}

/// The two sums of some cells.
class Sums {
 public:
  Sums(ValueRange range, std::size_t bins)
      : range_(range),
        scale_(range.width() > 0 ? double(bins) / range.width() : 0),
        volume_(bins),
        gradient_(bins) {}

  void add(const Corners& corners, double gradient, double volume) {
    const std::size_t first = bin_of(corners[0]), last = bin_of(corners[3]);
    double below = 0;
    for (std::size_t bin = first; bin < last; ++bin) {
      const double next = share_below(corners, range_.min + double(bin + 1) / scale_);
      add_to(bin, gradient, (next - below) * volume);
      below = next;
    }
    add_to(last, gradient, (1 - below) * volume);
  }
  std::size_t bin_of(double value) const {
    return std::min(std::size_t(std::max((value - range_.min) * scale_, 0.0)), volume_.size() - 1);
  }
  void add_to(std::size_t bin, double gradient, double volume) {
    volume_[bin] += volume;
    gradient_[bin] += gradient * volume;
  }
  void join(ByValue& whole) const {
    for (std::size_t i = 0; i < volume_.size(); ++i) {
      whole.volume[i] += volume_[i];
      whole.gradient[i] += gradient_[i];
    }
  }

 private:
  ValueRange range_;
  double scale_;
  std::vector<double> volume_, gradient_;
};

/// The corners of a cell: bit 0 of the index is a step along x, bit 1 along y, bit 2 along z.
using Cell = std::array<double, 8>;

/// The six ways from the first corner to the last along edges, an axis each: a tetrahedron's corners.
constexpr int axis_orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

void add_cell(Sums& sums, const Cell& cell, glm::dvec3 spacing) {
  const double volume = spacing.x * spacing.y * spacing.z / 6;
  const auto [low, high] = std::minmax_element(cell.begin(), cell.end());
  if (*low == *high) return sums.add_to(sums.bin_of(*low), 0, 6 * volume);
  for (const auto& axes : axis_orders) {
    Corners corners{cell[0]};
    glm::dvec3 gradient;
    std::size_t corner = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      corner |= std::size_t(1) << axes[i];
      corners[i + 1] = cell[corner];
      gradient[axes[i]] = (corners[i + 1] - corners[i]) / spacing[axes[i]];
    }
    sums.add(sorted(corners), glm::length(gradient), volume);
  }
}

/// The four rows of points on which a row of cells has its corners: a step along y, then one along z.
class CornerRows {
 public:
  CornerRows(const Volume& volume, int j, int k) {
    for (int r = 0; r < 4; ++r)
      rows_[std::size_t(r)] = volume.values.part(volume.index(0, j + (r & 1), k + (r >> 1)),
                                                 std::size_t(volume.grid.dims.x), rooms_[std::size_t(r)]);
  }
  Cell cell(int i) const {
    Cell cell;
    for (std::size_t c = 0; c < 8; ++c) cell[c] = rows_[c >> 1][std::size_t(i) + (c & 1)];
    return cell;
  }

 private:
  std::array<std::vector<float>, 4> rooms_;
  std::array<std::span<const float>, 4> rows_;
};

bool is_empty(const Cell& cell) {
  return std::ranges::any_of(cell, [](double value) { return !std::isfinite(value); });
}

}  // namespace

std::optional<ByValue> measure_by_value(const Volume& volume, int bins, const std::stop_token& stop) {
  const ValueRange range = volume.statistics.range;
  const std::size_t count = std::size_t(std::max(bins, 1));
  const glm::ivec3 cells = volume.grid.dims - 1;
  const bool has_empty = volume.has_empty_cells();
  // A slice each, summed in order
  std::vector<std::optional<Sums>> slices(std::size_t(cells.z));
  const auto measure_slice = [&](int k) {
    Sums& sums = slices[std::size_t(k)].emplace(range, count);
    for (int j = 0; j < cells.y && !stop.stop_requested(); ++j) {
      const CornerRows rows(volume, j, k);
      for (int i = 0; i < cells.x; ++i) {
        const Cell cell = rows.cell(i);
        if (!has_empty || !is_empty(cell)) add_cell(sums, cell, volume.grid.spacing);
      }
    }
  };
  // Half of the cores: this is done beside what a person looks at
  tbb::task_arena arena(std::max(1, tbb::this_task_arena::max_concurrency() / 2));
  arena.execute([&] { tbb::parallel_for(0, cells.z, measure_slice); });
  if (stop.stop_requested()) return std::nullopt;
  ByValue whole{range, std::vector<double>(count), std::vector<double>(count)};
  for (const auto& sums : slices) sums->join(whole);
  return whole;
}

std::vector<double> surface_area(const ByValue& by_value) {
  std::vector<double> area(by_value.bins());
  const double width = by_value.bin_width();
  if (width > 0)
    for (std::size_t i = 0; i < area.size(); ++i) area[i] = by_value.gradient[i] / width;
  return area;
}

std::vector<double> mean_gradient(const ByValue& by_value) {
  std::vector<double> mean(by_value.bins());
  for (std::size_t i = 0; i < mean.size(); ++i)
    if (by_value.volume[i] > 0) mean[i] = by_value.gradient[i] / by_value.volume[i];
  return mean;
}

std::vector<double> enclosed_volume(const ByValue& by_value) {
  std::vector<double> above(by_value.bins());
  double sum = 0;
  for (std::size_t i = above.size(); i-- > 0;) above[i] = sum += by_value.volume[i];
  return above;
}

}  // namespace crest
