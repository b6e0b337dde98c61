#include "render/raycaster/trace_ray.h"

#include <gtest/gtest.h>

#include "presets/error.h"
#include "presets/preset_file.h"
#include "render/reference/exact_ray.h"
#include "render/reference/reference.h"
#include "render/scene/camera.h"
#include "render/volume/builtin.h"
#include "tests/debug_context.h"

namespace crest::testing {
namespace {

constexpr glm::ivec2 size{8, 6};

class TraceRay : public ::testing::Test {
 protected:
  Scene scene_in(Mode mode) {
    Scene scene = make_scene(volume, load_preset("four-peaks"));
    scene.rendering.mode = mode;
    scene.rendering.early_termination = 0;
    return scene;
  }

  DebugContext context;
  Raycaster raycaster;
  std::shared_ptr<const Volume> volume = std::make_shared<const Volume>(make_builtin("gyroid?n=16"));
  Camera camera = whole_volume_camera(volume->grid, aspect_of(size));
};

// What is traced, and what is picked, is what the pixel shows: also where all rays are parallel.
TEST_F(TraceRay, AgreesWithTheExactRayInParallelProjection) {
  camera.projection = Projection::parallel;
  Scene scene = scene_in(Mode::both);
  scene.rendering.step = 0.05;
  gl::RenderTarget target(size, false);
  raycaster.draw(scene, camera, target);
  const Image picture = target.read_color();
  const ExactRays rays(scene, camera, size, Answer::integral_and_crossings);
  int shown = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const auto steps = trace_ray(raycaster, scene, camera, size, {x, y});
      const ExactRay exact = rays.at({x, y});
      ASSERT_EQ(steps.empty(), exact.places.empty());
      if (steps.empty()) continue;
      EXPECT_NEAR(steps.back().color.a, picture.at(x, y).a, 2e-6);
      EXPECT_NEAR(exact.places.back().opacity, picture.at(x, y).a, 0.02);
      EXPECT_NEAR(steps.back().depth, exact.exit - exact.enter, 2e-2);
      ++shown;
    }
  EXPECT_GT(shown, size.x * size.y / 4);
}

// The last step is the pixel that the ray caster draws, with its crossings, in every mode and classification.
TEST_F(TraceRay, EndsAsThePictureDoes) {
  for (const Mode mode : {Mode::dvr_only, Mode::peak_only, Mode::peak_xor_dvr, Mode::both})
    for (const auto method : {ClassificationMethod::post, ClassificationMethod::preintegrated}) {
      Scene scene = scene_in(mode);
      scene.rendering.classification = method;
      gl::RenderTarget target(size, true);
      const auto counts = raycaster.draw_counts(scene, camera, target);
      const Image picture = target.read_color();
      int traced = 0;
      for (const glm::ivec2 pixel :
           {glm::ivec2(0, 0), glm::ivec2(2, 1), glm::ivec2(4, 3), glm::ivec2(5, 4)}) {
        const auto steps = trace_ray(raycaster, scene, camera, size, pixel);
        const std::size_t index = std::size_t(pixel.y * size.x + pixel.x);
        ASSERT_EQ(!steps.empty(), counts[index].hit);
        if (steps.empty()) continue;
        ++traced;
        for (int channel = 0; channel < 4; ++channel)
          EXPECT_NEAR(steps.back().color[channel], picture.pixels[index][channel], 2e-6);
        EXPECT_EQ(steps.back().crossings, counts[index].crossings);
        EXPECT_EQ(steps.front().color, glm::vec4(0));
        for (std::size_t i = 1; i < steps.size(); ++i) {
          EXPECT_GT(steps[i].depth, steps[i - 1].depth);
          EXPECT_GE(steps[i].color.a, steps[i - 1].color.a - 1e-6F);
          EXPECT_GE(steps[i].crossings, steps[i - 1].crossings);
        }
      }
      EXPECT_GE(traced, 2);
    }
}

TEST_F(TraceRay, StepsAreAStepApart) {
  Scene scene = scene_in(Mode::dvr_only);
  scene.rendering.step = 0.5;
  scene.rendering.placement = Placement::entry;
  const auto steps = trace_ray(raycaster, scene, camera, size, {4, 3});
  ASSERT_GT(steps.size(), 20u);
  const double step = 0.5 * volume->grid.smallest_spacing();
  EXPECT_NEAR(steps[1].depth, 0.5 * step, 1e-5) << "the first sample lies in the middle of its segment";
  for (std::size_t i = 2; i < steps.size(); ++i) EXPECT_NEAR(steps[i].depth - steps[i - 1].depth, step, 1e-5);
}

TEST_F(TraceRay, SaysWhatItCannotTrace) {
  Scene scene = scene_in(Mode::dvr_only);
  scene.rendering.classification = ClassificationMethod::analytic;
  EXPECT_THROW(trace_ray(raycaster, scene, camera, size, {4, 3}), Error);
  scene.rendering.classification = ClassificationMethod::post;
  scene.rendering.step = 0.001;
  EXPECT_THROW(trace_ray(raycaster, scene, camera, size, {4, 3}), Error);
}

}  // namespace
}  // namespace crest::testing
