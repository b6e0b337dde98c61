#include "render/studies/vdls_performance.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "render/measure/timing.h"
#include "render/reference/reference.h"

namespace crest {
namespace {

constexpr std::uint64_t seed = 2006;
/// Samples are counted on pictures so much smaller, of so many views.
constexpr int count_coarseness = 4, counted_views = 4;

Scene scene_of(Scene scene, const VdlsSetup& setup) {
  scene.rendering.engine = setup.engine;
  scene.rendering.skipping = setup.skipping;
  return scene;
}

double samples_of(Renderer& renderer, const Scene& scene, const Camera& camera, glm::ivec2 size) {
  gl::RenderTarget counted((size + count_coarseness - 1) / count_coarseness, true);
  const RenderCounts counts = sum_of(renderer.draw_counts(scene, camera, counted));
  return counts.samples / counts.pixels * size.x * size.y;
}

}  // namespace

VdlsSetup vdls_setup(std::string name, const VdlsOptions& options) {
  return {std::move(name), Engine::vdls, options, true};
}

std::vector<VdlsSetup> table_setups() {
  VdlsOptions enhanced;
  enhanced.layers_per_pass = 2;
  return {vdls_setup("VDLS basic", VdlsOptions::basic()),
          vdls_setup("VDLS enhanced", enhanced),
          vdls_setup("VDLS", {}),
          {"ray caster", Engine::raycaster, {}, false},
          {"ray caster, skipping", Engine::raycaster, {}, true}};
}

std::vector<VdlsSetup> engine_setups() {
  return {vdls_setup("VDLS", {}), {"ray caster", Engine::raycaster, {}, true}};
}

double VdlsTiming::mean_ms() const {
  return std::accumulate(frame_ms.begin(), frame_ms.end(), 0.0) /
         double(std::max(frame_ms.size(), std::size_t(1)));
}

std::vector<VdlsTiming> time_setups(Renderer& renderer, const Scene& scene, glm::ivec2 size,
                                    const std::vector<VdlsSetup>& setups, const VdlsEffort& effort) {
  gl::RenderTarget target(size, false);
  const auto views = random_views(scene.volume->grid, effort.views, seed);
  const auto draw_ms = [&](const VdlsSetup& setup, const Camera& view) {
    if (effort.stop.stop_requested()) throw Cancelled();
    if (setup.engine == Engine::vdls) renderer.vdls().set_options(setup.options);
    return finished_ms([&] { renderer.draw(scene_of(scene, setup), view, target); });
  };
  std::vector<VdlsTiming> timings;
  for (const VdlsSetup& setup : setups) {
    timings.push_back({setup.name, {}, 0});
    draw_ms(setup, views.front());
    const std::size_t counted = std::min(views.size(), std::size_t(counted_views));
    for (std::size_t i = 0; i < counted; ++i)
      timings.back().samples +=
          samples_of(renderer, scene_of(scene, setup), views[i], size) / double(counted);
  }
  const auto begin = std::chrono::steady_clock::now();
  for (const Camera& view : views) {
    for (std::size_t i = 0; i < setups.size(); ++i) timings[i].frame_ms.push_back(draw_ms(setups[i], view));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    if (taken.count() > effort.seconds) break;
  }
  return timings;
}

PowerFit fit_power(const VdlsSeries& series, std::size_t setup) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto xy = [&](const VdlsSeries::Point& point) {
    return glm::dvec2(std::log(point.x), std::log(point.timings[setup].mean_ms()));
  };
  for (const auto& point : series.points) {
    const glm::dvec2 p = xy(point);
    n += 1;
    sx += p.x;
    sy += p.y;
    sxx += p.x * p.x;
    sxy += p.x * p.y;
  }
  PowerFit fit;
  fit.exponent = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  for (const auto& point : series.points) {
    const glm::dvec2 p = xy(point);
    const double residual = p.y - (sy - fit.exponent * sx) / n - fit.exponent * p.x;
    fit.largest_residual = std::max(fit.largest_residual, std::abs(std::expm1(residual)));
  }
  return fit;
}

}  // namespace crest
