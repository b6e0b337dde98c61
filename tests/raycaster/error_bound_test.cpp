// The exact march tells how far each pixel may be from the exact answer, at most.
#include <fmt/core.h>

#include <cstdlib>

#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/reference/reference.h"
#include "render/volume/builtin.h"
#include "render/volume/random.h"
#include "tests/raycaster/fixture.h"
#include "tests/raycaster/random_view.h"

namespace crest::testing {
namespace {

/// How the bounds of a picture's pixels are to their errors.
struct Bounds {
  double pixels = 0, small = 0, broken = 0, worst_ratio = 0;
  double sum_errors = 0, sum_bounds = 0;
};

class ErrorBound : public RaycasterTest {
 protected:
  void compare(const Scene& scene, const Camera& camera, glm::ivec2 size, Bounds& bounds,
               const std::string& what) {
    const ExactAnswer exact = exact_answers_of(scene.rendering).front();
    const Reference truth = render_reference(scene, camera, size, exact.answer, 1e-8);
    gl::RenderTarget target(size, true);
    const auto counts = raycaster.draw_counts(scene, camera, target);
    const Image image = target.read_color();
    for (std::size_t i = 0; i < counts.size(); ++i) {
      double error = 0;
      for (int c = 0; c < 4; ++c)
        error = std::max(error, std::abs(double(image.pixels[i][c]) - truth.pixels[i][c]));
      const double bound = double(counts[i].error_bound);
      ++bounds.pixels;
      bounds.small += bound <= 1.0 / 255;
      bounds.sum_errors += error;
      bounds.sum_bounds += bound;
      bounds.worst_ratio = std::max(bounds.worst_ratio, error / std::max(bound, 1e-30));
      if (error <= bound || bound == 1) continue;  // no channel is further off than 1
      ++bounds.broken;
      fmt::print("{}: pixel ({}, {}) is {:.3g} off, at most {:.3g} was told; grazing {}, crossings {} {}\n",
                 what, i % std::size_t(size.x), i / std::size_t(size.x), error, bound, truth.grazing[i],
                 truth.crossings[i], counts[i].crossings);
    }
  }
};

// CREST_SCENES=4000 takes more of them.
TEST_F(ErrorBound, HoldsInRandomScenes) {
  const char* asked = std::getenv("CREST_SCENES");
  const std::uint64_t scenes = asked ? std::strtoull(asked, nullptr, 10) : 200;
  Bounds bounds;
  for (std::uint64_t seed = 0; seed < scenes; ++seed) {
    const View view = analytic_view(seed);
    compare(view.scene, view.camera, {24, 24}, bounds,
            fmt::format("seed {}, {}", seed, name_of(view.scene.rendering.mode)));
  }
  fmt::print(
      "{} pixels, {} within 1/255 by their bounds, {} beyond them (ratio {:.3g}); mean error {:.3g}, mean "
      "bound {:.3g}\n",
      bounds.pixels, bounds.small, bounds.broken, bounds.worst_ratio, bounds.sum_errors / bounds.pixels,
      bounds.sum_bounds / bounds.pixels);
  EXPECT_EQ(bounds.broken, 0);
  EXPECT_GT(bounds.pixels, 100 * scenes);
  EXPECT_GT(bounds.small, 0.9 * bounds.pixels);
}

/// A ray through the middle of a smooth field, from somewhere.
View grazing_view(std::uint64_t seed) {
  Random random(seed);
  const auto unit = [&] { return random.uniform(0, 1); };
  const glm::dvec3 phase(6 * unit(), 6 * unit(), 6 * unit());
  Grid grid{glm::ivec3(12), glm::dvec3(1, 1 + unit(), 0.5 + unit()), glm::dvec3(0)};
  View view;
  view.scene.volume = make_volume(grid, [=](glm::dvec3 p) {
    return std::sin(0.5 * p.x + phase.x) + std::cos(0.6 * p.y + phase.y) * std::sin(0.4 * p.z + phase.z);
  });
  view.camera = whole_volume_camera(grid, 1);
  view.camera.eye += glm::dvec3(5 * unit(), 5 * unit(), 5 * unit());
  view.scene.rendering.classification = ClassificationMethod::analytic;
  return view;
}

/// The greatest value on the ray: above it no surface is met.
double greatest_on_ray(Scene scene, const Camera& camera) {
  scene.rendering.mode = Mode::peak_only;
  ValueRange between = scene.volume->statistics.range;
  while (between.width() > 1e-14) {
    const double middle = between.min + 0.5 * between.width();
    scene.tf = make_tf({point(middle, 0), point(middle, 1), point(middle, 0)});
    const Reference truth = render_reference(scene, camera, {1, 1}, Answer::crossings, 1e-8);
    if (middle == between.min || middle == between.max) break;
    (truth.crossings.front() > 0 ? between.min : between.max) = middle;
  }
  return between.min;
}

// A ray's own extremum is where a surface, or a step, is met twice or not at all: at distances about the
// rounding of 32-bit float nobody can know, and the bound must say so.
TEST_F(ErrorBound, HoldsWhereRaysGraze) {
  Bounds bounds;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    View view = grazing_view(seed);
    const double top = greatest_on_ray(view.scene, view.camera);
    for (const double distance : {-1e-6, -1e-7, -1e-8, 0.0, 1e-8, 1e-7}) {
      const double v = top + distance;
      const TransferFunction tfs[] = {
          make_tf({point(v, 0), point(v, 1), point(v, 0)}),
          make_tf({point(-9, 0.5), point(v, 0.5), point(v, 0.999, {1, 0, 0}), point(v, 0.5), point(9, 0.5)}),
          make_tf({point(v, 0), point(v, 1, {0, 1, 0}), point(9, 1, {0, 1, 0})}, 1e-3),
          make_tf(
              {point(-9, 0.9, {1, 0, 0}), point(v, 0.9, {1, 0, 0}), point(v, 0.9, {0, 0, 1}), point(9, 0.9)},
              1e-4),
          make_tf({point(v, 0), point(v, 0.01), point(v, 0), point(v + 1e-9, 0), point(v + 1e-9, 1),
                   point(v + 1e-9, 0)}),
          make_tf({point(v, 0), point(v + 2e-9, 1), point(v + 4e-9, 0)}, 1e-9)};
      for (const TransferFunction& tf : tfs)
        for (const Mode mode : {Mode::peak_only, Mode::dvr_only, Mode::both}) {
          view.scene.tf = tf;
          view.scene.rendering.mode = mode;
          compare(view.scene, view.camera, {1, 1}, bounds,
                  fmt::format("seed {}, {} at {:g}", seed, name_of(mode), distance));
        }
    }
  }
  fmt::print("{} rays, mean error {:.3g}, mean bound {:.3g}\n", bounds.pixels,
             bounds.sum_errors / bounds.pixels, bounds.sum_bounds / bounds.pixels);
  EXPECT_EQ(bounds.broken, 0);
  EXPECT_GT(bounds.sum_errors, 5) << "some rays are far off";
  EXPECT_LT(bounds.sum_bounds, 0.8 * bounds.pixels);
}

// What ends a ray early is an error, too; and passes add up.
TEST_F(ErrorBound, HoldsWithEarlyTerminationAndInPasses) {
  Bounds bounds;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    View view = analytic_view(seed);
    view.scene.rendering.early_termination = 0.05;
    raycaster.force({.features = {}, .intervals_per_pass = seed % 2 == 0 ? 0 : 3});
    compare(view.scene, view.camera, {24, 24}, bounds, fmt::format("seed {}", seed));
  }
  EXPECT_EQ(bounds.broken, 0);
}

TEST_F(ErrorBound, IsSmallInOrdinaryScenes) {
  for (const auto& [volume, preset] : {std::pair("plume?n=64", "dirac-shell"),
                                       {"gyroid?n=48", "four-peaks"},
                                       {"marschner-lobb?n=48", "four-peaks"},
                                       {"noise?n=48", "smooth-haze"},
                                       {"noise?n=48", "noisy-band"},
                                       {"sphere?n=48", "onion"},
                                       {"vessels?n=64", "vessels-shell"}})
    for (const Mode mode : {Mode::dvr_only, Mode::peak_only, Mode::peak_xor_dvr, Mode::both}) {
      Scene scene = make_scene(std::make_shared<const Volume>(make_builtin(volume)), load_preset(preset));
      scene.rendering.mode = mode;
      scene.rendering.classification = ClassificationMethod::analytic;
      scene.rendering.shading = Shading::none;
      scene.rendering.early_termination = 0;
      Bounds bounds;
      compare(scene, whole_volume_camera(scene.volume->grid, 1), {64, 64}, bounds, volume);
      fmt::print("{} {}: {:.5f} within 1/255 by their bounds, mean error {:.3g}, mean bound {:.3g}\n", volume,
                 name_of(mode), bounds.small / bounds.pixels, bounds.sum_errors / bounds.pixels,
                 bounds.sum_bounds / bounds.pixels);
      EXPECT_EQ(bounds.broken, 0) << volume;
      EXPECT_GT(bounds.small, 0.99 * bounds.pixels) << volume << " " << name_of(mode);
    }
}

}  // namespace
}  // namespace crest::testing
