#include <gtest/gtest.h>

#include <fmt/core.h>

#include <cmath>

#include "presets/error.h"
#include "presets/preset_file.h"
#include "render/scene/camera.h"
#include "tests/reference/rays.h"

// Pictures as a whole: progress and cancelling, sizes, and what 32-bit float costs.
namespace crest::testing {
namespace {

Scene library_scene(const char* volume, const char* preset) {
  return make_scene(std::make_shared<const Volume>(make_builtin(volume)), load_preset(preset));
}

TEST(ReferencePicture, TellsItsProgress) {
  const Scene scene = library_scene("sphere?n=9", "onion");
  std::vector<double> told;
  const Progress progress = [&](double done) {
    told.push_back(done);
    return true;
  };
  render_reference(scene, whole_volume_camera(scene.volume->grid, 1), {50, 41}, Answer::integral, 1e-10,
                   progress);
  ASSERT_GT(told.size(), 10u);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_GT(told.front(), 0);
  EXPECT_EQ(told.back(), 1);
}

TEST(ReferencePicture, StopsWhenItIsTold) {
  const Scene scene = library_scene("sphere?n=9", "onion");
  int calls = 0;
  const Progress progress = [&](double done) {
    ++calls;
    return done < 0.2;
  };
  EXPECT_THROW(render_reference(scene, whole_volume_camera(scene.volume->grid, 1), {100, 100},
                                Answer::integral, 1e-10, progress),
               Cancelled);
  EXPECT_LT(calls, 100 * 100 / 64 / 2);
}

TEST(ReferencePicture, RefusesWhatIsNoPicture) {
  const Scene scene = library_scene("sphere?n=9", "onion");
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  for (const glm::ivec2 size : {glm::ivec2(0, 8), {8, 0}, {-1, 8}})
    EXPECT_THROW(render_reference(scene, camera, size, Answer::integral), Error);
  Camera blind = camera;
  blind.target = blind.eye;
  EXPECT_THROW(render_reference(scene, blind, {8, 8}, Answer::integral), Error);
}

// A clip box beside the volume leaves nothing of it, also where it is beside it on one axis alone.
TEST(ReferencePicture, NothingLiesInAClipBoxBesideTheVolume) {
  Scene scene = library_scene("sphere?n=9", "smooth-haze");
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  for (const double beside : {1.01, 1.5, 5.0}) {
    scene.rendering.clip_box = ClipBox{{beside, -1, -1}, {beside + 1, 1, 1}, {}};
    for (const glm::dvec4& pixel : render_reference(scene, camera, {32, 32}, Answer::integral).pixels)
      ASSERT_EQ(pixel, glm::dvec4(0)) << beside;
  }
}

// The numbers are printed: what a renderer in 32-bit float cannot do better than, whatever its sampling.
TEST(ReferencePicture, WhatFloatCosts) {
  for (const auto& [volume, preset] : {std::pair("plume?n=24", "dirac-shell"),
                                       {"vessels?n=32", "vessels-shell"},
                                       {"gyroid?n=24", "four-peaks"},
                                       {"marschner-lobb?n=24", "smooth-haze"}}) {
    const Scene scene = library_scene(volume, preset);
    const Camera camera = whole_volume_camera(scene.volume->grid, 1);
    for (const Answer answer : {Answer::integral, Answer::crossings, Answer::base_and_crossings}) {
      const glm::ivec2 size(48, 48);
      const Reference exact = render_reference(scene, camera, size, answer),
                      in_float = render_reference_in_float(scene, camera, size, answer);
      double most = 0, sum = 0;
      int grazing = 0, miscounted = 0;
      for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
        grazing += exact.grazing[i];
        if (exact.grazing[i]) continue;
        miscounted += exact.crossings[i] != in_float.crossings[i];
        const glm::dvec4 off = glm::abs(exact.pixels[i] - in_float.pixels[i]);
        most = std::max({most, off.r, off.g, off.b, off.a});
        sum += glm::dot(off, off) / 4;
      }
      const double rmse = std::sqrt(sum / double(exact.pixels.size()));
      fmt::print("{:20} {:14} {:16} rmse {:.1e} max {:.1e}, {} grazing pixels\n", volume, preset,
                 name_of(answer), rmse, most, grazing);
      EXPECT_EQ(miscounted, 0);
      EXPECT_LT(most, 1e-5);
      EXPECT_GT(most, 1e-9);  // it is not the same arithmetic twice
      EXPECT_LT(grazing, 10);
    }
  }
}

}  // namespace
}  // namespace crest::testing
