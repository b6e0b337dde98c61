// The exact march tells how far each pixel may be from the exact answer, at most.
#include <fmt/core.h>

#include <cstdlib>

#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/reference/reference.h"
#include "render/volume/builtin.h"
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
      if (!counts[i].hit) continue;
      double error = 0;
      for (int c = 0; c < 4; ++c)
        error = std::max(error, std::abs(double(image.pixels[i][c]) - truth.pixels[i][c]));
      const double bound = double(counts[i].error_bound);
      ++bounds.pixels;
      bounds.small += bound <= 1.0 / 255;
      bounds.sum_errors += error;
      bounds.sum_bounds += bound;
      bounds.worst_ratio = std::max(bounds.worst_ratio, error / std::max(bound, 1e-30));
      if (error <= bound) continue;
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
