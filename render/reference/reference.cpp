#include "render/reference/reference.h"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "presets/error.h"
#include "render/reference/formula_field.h"
#include "render/reference/pixel_ray.h"
#include "render/reference/ray_solver.h"
#include "render/reference/solved_scene.h"

namespace crest {
namespace {

using namespace reference;

constexpr std::size_t pixels_per_task = 64;

/// Calls render_pixel(index) for each pixel, in parallel. Throws Cancelled when `progress` asks for it.
template <class RenderPixel>
void for_each_pixel(std::size_t count, const Progress& progress, const RenderPixel& render_pixel) {
  std::mutex one_at_a_time;
  std::atomic<bool> stop = false;
  std::size_t done = 0;
  const auto render_task = [&](std::size_t task) {
    const std::size_t begin = task * pixels_per_task, end = std::min(begin + pixels_per_task, count);
    for (std::size_t index = begin; index < end; ++index) {
      if (stop) return;
      render_pixel(index);
    }
    const std::scoped_lock lock(one_at_a_time);
    done += end - begin;
    if (progress && !stop && !progress(double(done) / double(count))) stop = true;
  };
  tbb::parallel_for(std::size_t(0), (count + pixels_per_task - 1) / pixels_per_task, render_task);
  if (stop) throw Cancelled();
}

/// The picture, where solve(solver, ray) gives the solver the field along a ray.
template <class Real, class Solve>
Reference render(const Scene& scene, const Camera& camera, glm::ivec2 size, const Levels<Real>& levels,
                 double tolerance, const Progress& progress, const Solve& solve) {
  if (size.x < 1 || size.y < 1)
    throw Error(fmt::format("a picture of {}x{} pixels has none", size.x, size.y));
  const PixelRays rays = pixel_rays(scene.volume->grid, scene.rendering.clip_box, camera, size);
  const std::size_t width = std::size_t(size.x), count = width * std::size_t(size.y);
  Reference result{.size = size,
                   .pixels = std::vector<glm::dvec4>(count),
                   .crossings = std::vector<std::uint32_t>(count),
                   .grazing = std::vector<std::uint8_t>(count)};
  for_each_pixel(count, progress, [&](std::size_t index) {
    const PixelRay<Real> ray = pixel_ray<Real>(rays, int(index % width), int(index / width));
    RaySolver<Real> solver(levels, tolerance);
    solve(solver, ray);
    const Collected<Real>& found = solver.collected();
    result.pixels[index] = {glm::dvec3(found.color), double(found.alpha)};
    result.crossings[index] = found.crossings;
    result.grazing[index] = found.grazing || ray.grazes_box;
  });
  return result;
}

template <class Real>
Reference render_volume(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                        double tolerance, const Progress& progress) {
  const SolvedScene<Real> solved = solved_scene<Real>(scene, answer);
  return render(scene, camera, size, solved.levels.levels, tolerance, progress,
                [&](RaySolver<Real>& solver, const PixelRay<Real>& ray) {
                  solve_volume(solver, solved.fields, solved.levels, tolerance, ray);
                });
}

}  // namespace

Image Reference::image() const {
  Image image{size, {}};
  image.pixels.assign(pixels.begin(), pixels.end());
  return image;
}

Reference render_reference(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                           double tolerance, const Progress& progress) {
  return render_volume<double>(scene, camera, size, answer, tolerance, progress);
}

Reference render_reference_in_float(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                                    double tolerance, const Progress& progress) {
  return render_volume<float>(scene, camera, size, answer, tolerance, progress);
}

Reference render_reference(const FormulaField& field, const Scene& scene, const Camera& camera,
                           glm::ivec2 size, Answer answer, double tolerance, const Progress& progress) {
  const Volume& volume = *scene.volume;
  const ValueRange range = volume.statistics.range;
  const double usual_value = std::max(std::abs(range.min), std::abs(range.max));
  // The formula may go beyond the values of its samples.
  const auto surfaces = shown_peaks(find_peaks(scene.tf));
  return render(scene, camera, size, levels_of<double>(scene, answer, surfaces), tolerance, progress,
                [&](RaySolver<double>& solver, const PixelRay<double>& ray) {
                  solve_formula(solver, field, volume.grid, usual_value, ray);
                });
}

}  // namespace crest
