#include "render/studies/vdls/performance.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
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
  scene.rendering.vdls = setup.options;
  scene.rendering.skipping = setup.skipping;
  return scene;
}

double samples_of(Renderer& renderer, const Scene& scene, const Camera& camera, glm::ivec2 size) {
  gl::RenderTarget counted((size + count_coarseness - 1) / count_coarseness, true);
  const RenderCounts counts = sum_of(renderer.draw_counts(scene, camera, counted));
  return counts.samples / counts.pixels * size.x * size.y;
}

/// A subject with what draws it.
struct Stage {
  VdlsSubject subject;
  std::vector<Camera> views;
  std::unique_ptr<gl::RenderTarget> target;
  std::shared_ptr<Renderer> renderer;

  Stage(const VdlsSubject& drawn, int count, std::shared_ptr<Renderer> drawn_by)
      : subject(drawn),
        views(random_views(drawn.scene.volume->grid, count, seed)),
        target(std::make_unique<gl::RenderTarget>(drawn.size, false)),
        renderer(std::move(drawn_by)) {}

  bool serves(const VdlsSubject& other) const {
    return subject.scene.volume == other.scene.volume && subject.scene.tf == other.scene.tf &&
           subject.size == other.size;
  }
  double draw_ms(const VdlsSetup& setup, std::size_t view, const std::stop_token& stop) const {
    if (stop.stop_requested()) throw Cancelled();
    return finished_ms([&] { renderer->draw(scene_of(subject.scene, setup), views[view], *target); });
  }
  /// First frames and counts.
  std::vector<VdlsTiming> begin(const std::stop_token& stop) {
    std::vector<VdlsTiming> timings;
    const std::size_t counted = std::min(views.size(), std::size_t(counted_views));
    for (const VdlsSetup& setup : subject.setups) {
      timings.push_back({setup.name, {}, 0});
      draw_ms(setup, 0, stop);
      for (std::size_t i = 0; i < counted; ++i)
        timings.back().samples +=
            samples_of(*renderer, scene_of(subject.scene, setup), views[i], subject.size) / double(counted);
    }
    return timings;
  }
};

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

std::vector<std::vector<VdlsTiming>> time_subjects(Renderer& renderer,
                                                   const std::vector<VdlsSubject>& subjects,
                                                   const VdlsEffort& effort) {
  std::vector<Stage> stages;
  for (const VdlsSubject& subject : subjects) {
    const auto same = std::ranges::find_if(stages, [&](const Stage& s) { return s.serves(subject); });
    auto drawn_by = stages.empty()         ? std::shared_ptr<Renderer>(&renderer, [](Renderer*) {})
                    : same != stages.end() ? same->renderer
                                           : std::make_shared<Renderer>();
    stages.emplace_back(subject, effort.views, std::move(drawn_by));
  }
  std::vector<std::vector<VdlsTiming>> timings;
  for (Stage& stage : stages) timings.push_back(stage.begin(effort.stop));
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t view = 0; view < std::size_t(effort.views); ++view) {
    for (std::size_t i = 0; i < stages.size(); ++i)
      for (std::size_t k = 0; k < timings[i].size(); ++k)
        timings[i][k].frame_ms.push_back(stages[i].draw_ms(subjects[i].setups[k], view, effort.stop));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    if (taken.count() > effort.seconds) break;
  }
  return timings;
}

LineFit fit_line(const VdlsSeries& series, std::size_t setup, double power) {
  // Each residual is weighed with the time it is of: t (a + b x) = 1 in the sense of least squares
  double saa = 0, sab = 0, sbb = 0, sa = 0, sb = 0, largest = 0;
  const auto time_of = [&](const VdlsSeries::Point& point) { return point.timings[setup].mean_ms(); };
  for (const auto& point : series.points) {
    const double x = std::pow(point.x, power), a = 1 / time_of(point), b = x / time_of(point);
    saa += a * a;
    sab += a * b;
    sbb += b * b;
    sa += a;
    sb += b;
    largest = std::max(largest, x);
  }
  const double determinant = saa * sbb - sab * sab;
  LineFit fit;
  fit.fixed_ms = (sbb * sa - sab * sb) / determinant;
  fit.ms_per_unit = (saa * sb - sab * sa) / determinant;
  fit.fixed_share = fit.fixed_ms / (fit.fixed_ms + fit.ms_per_unit * largest);
  for (const auto& point : series.points) {
    const double fitted = fit.fixed_ms + fit.ms_per_unit * std::pow(point.x, power);
    fit.largest_residual = std::max(fit.largest_residual, std::abs(fitted / time_of(point) - 1));
  }
  return fit;
}

Growth growth_of(const LineFit& fit) {
  if (!(fit.largest_residual <= 0.1) || fit.ms_per_unit <= 0) return Growth::other;
  return std::abs(fit.fixed_share) <= 0.1 ? Growth::proportional : Growth::linear;
}

}  // namespace crest
