#include <gtest/gtest-spi.h>

#include "presets/error.h"
#include "presets/preset_file.h"
#include "render/gl/errors.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

using Targets = RaycasterTest;

// A picture of more than 2 GiB is read in parts; here parts are small.
TEST_F(Targets, ArePartByPartWhatTheyAreAtOnce) {
  const auto volume = std::make_shared<const Volume>(make_builtin("sphere?n=16"));
  const Scene scene = make_scene(volume, load_preset("onion"));
  gl::RenderTarget target({13, 17}, true);
  raycaster.draw(scene, whole_volume_camera(volume->grid, 1), target);
  const auto color = target.read_color().pixels;
  const auto counts = target.read_counts();
  EXPECT_NE(color.front(), color[13 * 8 + 6]);
  const std::size_t row = 13 * sizeof(glm::vec4);
  for (const std::size_t part : {std::size_t(1), row, 3 * row - 1, 5 * row, 100 * row}) {
    EXPECT_EQ(target.read_color(part).pixels, color) << part;
    EXPECT_EQ(target.read_counts(part), counts) << part;
  }
}

// The tests' context tells of any wrong use of GL.
TEST_F(Targets, AWrongUseOfGlFailsATest) {
  EXPECT_NONFATAL_FAILURE(glBindTextureUnit(100000, 0), "");
  try {
    gl::require_no_error("drawing", {10, 20});
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "the graphics driver failed (GL error 0x501) while drawing a picture of 10x20 pixels");
  }
  gl::require_no_error("drawing", {10, 20});
}

// What nobody waits for is the same, also where the target is drawn into again before it is read, and in
// passes.
TEST_F(Targets, ReadWithoutWaiting) {
  Scene scene;
  scene.volume =
      make_volume({{9, 9, 9}, {1, 1, 1}, {-4, -4, -4}}, [](glm::dvec3 p) { return p.x + 0.1 * p.y; });
  scene.tf = make_tf({point(-4, 0), point(4, 0.5)});
  scene.rendering.skipping = false;
  const Camera camera = along_z(scene.volume->grid, 10);
  gl::RenderTarget target({24, 16}, true);
  for (const int intervals : {0, 5}) {
    Forced forced;
    forced.intervals_per_pass = intervals;
    forced.features.long_rays = intervals > 0;
    raycaster.force(forced);
    const auto counts = raycaster.draw_counts(scene, camera, target);
    const Image color = target.read_color();
    const PendingCounts pending = raycaster.begin_counts(scene, camera, target);
    const gl::PendingRead pending_color(target, gl::PendingRead::What::color);
    EXPECT_EQ(pending.passes.size() > 1, intervals > 0);
    Scene other = scene;
    other.tf.points.back().opacity = 0.1;
    raycaster.draw(other, camera, target);
    EXPECT_EQ(pending_color.color(), color.pixels);
    EXPECT_TRUE(pending_color.is_over());
    const auto taken = pending.take();
    ASSERT_EQ(taken.size(), counts.size());
    EXPECT_GT(sum_of(counts).samples, 0);
    EXPECT_EQ(sum_of(taken).samples, sum_of(counts).samples);
    EXPECT_EQ(sum_of(taken).hit_pixels, sum_of(counts).hit_pixels);
  }
}

}  // namespace
}  // namespace crest::testing
