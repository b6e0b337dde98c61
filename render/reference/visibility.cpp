#include "render/reference/visibility.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "render/reference/pixel_ray.h"
#include "render/reference/ray_solver.h"
#include "render/reference/solved_scene.h"

namespace crest {
namespace {

using namespace reference;

constexpr double tolerance = 1e-7;

/// The values between two bins, ascending; a range of no width has none.
std::vector<double> inner_ends(ValueRange range, int bins) {
  std::vector<double> ends;
  for (int i = 1; i < bins; ++i) {
    const double end = range.min + range.width() * i / bins;
    if (end > range.min && end < range.max && (ends.empty() || end > ends.back())) ends.push_back(end);
  }
  return ends;
}

std::size_t bin_of(const std::vector<double>& ends, double value) {
  return std::size_t(std::ranges::upper_bound(ends, value) - ends.begin());
}

/// The lower end of a piece is a level, and so is each bin's.
std::vector<std::size_t> bins_of_pieces(const Levels<double>& levels, const std::vector<double>& ends) {
  std::vector<std::size_t> bins(levels.pieces.size());
  for (std::size_t i = 1; i < bins.size(); ++i) bins[i] = bin_of(ends, levels.levels[i - 1].value.hi);
  return bins;
}

/// The sums of some rays.
struct Sums {
  std::vector<double> volume, surface;
};

void add(Sums& sums, const Shares<double>& shares, const std::vector<std::size_t>& bins,
         const std::vector<double>& ends) {
  for (std::size_t i = 0; i < bins.size(); ++i) sums.volume[bins[i]] += shares.of_piece[i];
  for (const auto& crossed : shares.of_surfaces) sums.surface[bin_of(ends, crossed.value)] += crossed.alpha;
}

}  // namespace

std::optional<Visibility> measure_visibility(const Scene& scene, const Camera& camera, glm::ivec2 size,
                                             int bins, const std::stop_token& stop) {
  const ValueRange range = scene.volume->statistics.range;
  const std::size_t count = std::size_t(std::max(bins, 1));
  const std::vector<double> ends = inner_ends(range, int(count));
  const SolvedScene<double> solved = solved_scene<double>(scene, answers_of(scene.rendering).front(), ends);
  const Levels<double>& levels = solved.levels.levels;
  const std::vector<std::size_t> bins_of = bins_of_pieces(levels, ends);
  const PixelRays rays = pixel_rays(scene.volume->grid, scene.rendering.clip_box, camera, size);

  // A row each, summed in order, so that the result does not depend on how many cores there are
  std::vector<Sums> rows(std::size_t(size.y));
  tbb::parallel_for(0, size.y, [&](int y) {
    Sums& sums = rows[std::size_t(y)];
    sums = {std::vector<double>(count), std::vector<double>(count)};
    for (int x = 0; x < size.x && !stop.stop_requested(); ++x) {
      Shares<double> shares{std::vector<double>(levels.pieces.size()), {}};
      RaySolver<double> solver(levels, tolerance);
      solver.tell_shares(shares);
      solve_volume(solver, solved.fields, solved.levels, tolerance, pixel_ray<double>(rays, x, y));
      add(sums, shares, bins_of, ends);
    }
  });
  if (stop.stop_requested()) return std::nullopt;

  Visibility found{range, std::vector<double>(count), std::vector<double>(count)};
  const double share = 1 / (double(size.x) * size.y);
  for (const Sums& row : rows)
    for (std::size_t i = 0; i < count; ++i) {
      found.volume[i] += share * row.volume[i];
      found.surface[i] += share * row.surface[i];
    }
  return found;
}

}  // namespace crest
