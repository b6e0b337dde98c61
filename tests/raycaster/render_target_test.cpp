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

}  // namespace
}  // namespace crest::testing
