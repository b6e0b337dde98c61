#include "render/reference/reference.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <mutex>

#include "presets/error.h"
#include "render/classify/classification.h"
#include "render/reference/cell_walk.h"
#include "render/reference/formula_walk.h"
#include "render/reference/levels.h"
#include "render/reference/pixel_ray.h"
#include "render/reference/ray_solver.h"

namespace crest {
namespace {

using namespace reference;

/// What the answer integrates, and what it shows at crossings.
template <class Real>
Levels<Real> levels_of(const Scene& scene, Answer answer) {
  const Classification classified = classify(scene.tf, scene.volume->statistics.range);
  TransferFunction tf = scene.tf;
  if (answer == Answer::crossings) tf.points.clear();
  if (answer == Answer::base_and_crossings) tf = base_transfer_function(tf, classified.peaks);
  std::span<const Peak> surfaces = classified.surfaces;
  if (answer == Answer::integral) surfaces = {};
  return make_levels<Real>(std::move(tf), surfaces, scene.volume->grid.smallest_spacing());
}

struct Pixel {
  glm::dvec4 color{0};
  std::uint32_t crossings = 0;
  bool grazing = false;
};

template <class Real>
Pixel finished(const RaySolver<Real>& solver, const PixelRay<Real>& ray) {
  const Collected<Real>& c = solver.collected();
  return {{glm::dvec3(c.color), double(c.alpha)}, c.crossings, c.grazing || ray.grazes_box};
}

/// A scene's trilinear field, solved ray by ray.
template <class Real>
struct TrilinearSolver {
  const Volume& volume;
  PixelRays rays;
  Levels<Real> levels;
  double tolerance;

  /// Adds the ray's part in a cell; whether anything may show behind it.
  bool add_cell(RaySolver<Real>& solver, const CellVisit<Real>& at, const PixelRay<Real>& ray) const {
    float corner[8];
    const glm::ivec3 dims = volume.grid.dims;
    const std::size_t row = std::size_t(dims.x), slice = row * std::size_t(dims.y);
    const float* first = volume.values.data() + std::size_t(at.cell.x) + row * std::size_t(at.cell.y) +
                         slice * std::size_t(at.cell.z);
    for (std::size_t i = 0; i < 8; ++i) corner[i] = first[(i & 1) + (i >> 1 & 1) * row + (i >> 2) * slice];
    if (volume.has_empty_cells() &&
        !std::all_of(corner, corner + 8, [](float v) { return std::isfinite(v); })) {
      solver.end_span();
      solver.begin_span();
      return true;
    }
    const auto [least, most] = std::minmax_element(corner, corner + 8);
    const Real low = Real(*least), high = Real(*most), range = high - low;
    const Real largest = std::max(std::abs(low), std::abs(high));
    const glm::dvec3 misplaced = ray.float_rounding;
    // A float field value: four roundings of it, and its change over those of the position.
    const Real float_rounding =
        Real(0x1p-22) * largest + range * Real(misplaced.x + misplaced.y + misplaced.z);

    if (!levels.surface_within(low - float_rounding, high + float_rounding)) {
      if (solver.is_opaque()) {
        solver.add_clear();
        return !levels.surfaces.empty();
      }
      if (!levels.visible_within(low, high)) {
        solver.add_clear();
        return true;
      }
      const std::size_t stretch = levels.stretch_at({high, 0});
      if (levels.stretches[stretch].is_constant && stretch == levels.stretch_at({low, 0}) &&
          (stretch == 0 || levels.levels[stretch - 1].value - Value<Real>{low, 0} < 0)) {
        solver.add_constant(levels.stretches[stretch], at.length);
        return true;
      }
    }
    // Positions in cells are good to a few roundings of the largest.
    const int size = std::max({dims.x, dims.y, dims.z});
    const Real rounding = std::numeric_limits<Real>::epsilon() * Real(4 * size + 16) * range;
    solver.add(FieldPiece<Real, cell_degree>{.offset = Real(corner[0]),
                                             .f = field_along(corner, at),
                                             .length = at.length,
                                             .rounding = rounding,
                                             .float_rounding = float_rounding});
    return true;
  }

  Pixel operator()(int x, int y) const {
    const PixelRay<Real> ray = pixel_ray<Real>(rays, x, y);
    RaySolver<Real> solver(levels, tolerance);
    solver.begin_span();
    if (ray.inside)
      walk_cells(rays.cells, *ray.inside,
                 [&](const CellVisit<Real>& at) { return add_cell(solver, at, ray); });
    solver.end_span();
    return finished(solver, ray);
  }
};

/// A formula over the box of a grid.
struct FormulaSolver {
  const FormulaField& field;
  const Grid& grid;
  PixelRays rays;
  Levels<double> levels;
  double tolerance;
  double largest;  ///< absolute value of the field

  Pixel operator()(int x, int y) const {
    const PixelRay<double> ray = pixel_ray<double>(rays, x, y);
    RaySolver<double> solver(levels, tolerance);
    solver.begin_span();
    if (ray.inside) {
      const auto position = [&](double t) {
        return grid.origin + grid.spacing * (ray.inside->origin + t * ray.inside->direction);
      };
      const auto value = [&](double t) { return field.value(position(t)); };
      const double rounding = 64 * std::numeric_limits<double>::epsilon() * largest;
      const auto visit = [&](const FittedPiece& piece) {
        const glm::dvec3 slope = field.gradient(position(piece.begin + piece.length / 2)) * grid.spacing;
        solver.add(FieldPiece<double, formula_degree>{
            .offset = piece.offset,
            .f = piece.f,
            .length = piece.length,
            .rounding = piece.rounding,
            .float_rounding = 0x1p-22 * largest + glm::dot(glm::abs(slope), ray.float_rounding)});
        return !solver.is_opaque() || !levels.surfaces.empty();
      };
      // Begun with pieces no longer than a cell, lest a thin feature falls between the points of the first
      // fit
      const double size = ray.inside->length;
      const int count = std::max(8, int(std::ceil(size)));
      for (int i = 0; i < count; ++i) {
        const double begin = size * i / count;
        if (!fit_pieces(value, begin, size * (i + 1) / count - begin, rounding, visit)) break;
      }
    }
    solver.end_span();
    return finished(solver, ray);
  }
};

template <class Solve>
Reference render_pixels(glm::ivec2 size, const Progress& progress, const Solve& solve) {
  if (size.x < 1 || size.y < 1)
    throw Error(fmt::format("a picture of {}x{} pixels has none", size.x, size.y));
  const std::size_t width = std::size_t(size.x), count = width * std::size_t(size.y);
  Reference result{.size = size,
                   .pixels = std::vector<glm::dvec4>(count),
                   .crossings = std::vector<std::uint32_t>(count),
                   .grazing = std::vector<std::uint8_t>(count)};
  std::mutex one_at_a_time;
  std::atomic<bool> stop = false;
  int rows_done = 0;
  const auto render_row = [&](int y) {
    for (int x = 0; x < size.x && !stop; ++x) {
      const Pixel pixel = solve(x, y);
      const std::size_t index = std::size_t(y) * width + std::size_t(x);
      result.pixels[index] = pixel.color;
      result.crossings[index] = pixel.crossings;
      result.grazing[index] = pixel.grazing;
    }
    const std::scoped_lock lock(one_at_a_time);
    ++rows_done;
    if (progress && !stop && !progress(double(rows_done) / size.y)) stop = true;
  };
  tbb::parallel_for(0, size.y, render_row);
  if (stop) throw Cancelled();
  return result;
}

template <class Real>
Reference render_trilinear(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                           double tolerance, const Progress& progress) {
  const TrilinearSolver<Real> solver{
      .volume = *scene.volume,
      .rays = pixel_rays(scene.volume->grid, scene.rendering.clip_box, camera, size),
      .levels = levels_of<Real>(scene, answer),
      .tolerance = tolerance};
  return render_pixels(size, progress, solver);
}

}  // namespace

Image Reference::image() const {
  Image image{size, {}};
  image.pixels.assign(pixels.begin(), pixels.end());
  return image;
}

Reference render_reference(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                           double tolerance, const Progress& progress) {
  return render_trilinear<double>(scene, camera, size, answer, tolerance, progress);
}

Reference render_reference_in_float(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                                    double tolerance, const Progress& progress) {
  return render_trilinear<float>(scene, camera, size, answer, tolerance, progress);
}

Reference render_reference(const FormulaField& field, const Scene& scene, const Camera& camera,
                           glm::ivec2 size, Answer answer, double tolerance, const Progress& progress) {
  const ValueRange range = scene.volume->statistics.range;
  const FormulaSolver solver{.field = field,
                             .grid = scene.volume->grid,
                             .rays = pixel_rays(scene.volume->grid, scene.rendering.clip_box, camera, size),
                             .levels = levels_of<double>(scene, answer),
                             .tolerance = tolerance,
                             .largest = std::max(std::abs(range.min), std::abs(range.max))};
  return render_pixels(size, progress, solver);
}

}  // namespace crest
