#include "app/ray_inspector.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "presets/preset_file.h"
#include "render/scene/camera.h"
#include "render/volume/builtin.h"
#include "tests/debug_context.h"

namespace crest {
namespace {

class RayInspectorTest : public ::testing::Test {
 protected:
  RayInspectorTest() { scene.rendering.step = 1; }

  testing::DebugContext context;
  Renderer renderer;
  std::shared_ptr<const Volume> volume = std::make_shared<const Volume>(make_builtin("gyroid?n=24"));
  Scene scene = make_scene(volume, load_preset("four-peaks"));
  Camera camera = whole_volume_camera(volume->grid, 1);
  RayAsk ask{0, {20, 20}, {48, 48}};
  RayInspector rays;
};

TEST_F(RayInspectorTest, SolvesAModeAtATime) {
  EXPECT_FALSE(rays.is_busy());
  rays.want(scene, camera, ask);
  int works = 0;
  for (; rays.is_busy(); ++works) rays.work(renderer);
  EXPECT_GE(works, view_count) << "the device may need some more";
  rays.want(scene, camera, ask);
  EXPECT_FALSE(rays.is_busy()) << "nothing changed";
  const RayInspection& inspection = *rays.inspection();
  const InspectedRay &surfaces = *inspection.modes[1], &volume_alone = *inspection.modes[0];
  EXPECT_GT(surfaces.crossings.exact.size(), 0u);
  EXPECT_EQ(volume_alone.crossings.exact.size(), 0u) << "DVR knows no surfaces";
  ASSERT_FALSE(surfaces.steps.empty());
  EXPECT_NEAR(surfaces.steps.front().depth, surfaces.exact.enter, 1e-9);
  EXPECT_NEAR(surfaces.steps.back().depth, surfaces.exact.exit, 1e-4);

  scene.tf.points.front().opacity += 0.01;
  rays.want(scene, camera, ask);
  EXPECT_TRUE(rays.is_busy());
  EXPECT_TRUE(rays.inspection()->modes[1]) << "what was known is shown meanwhile";
  ask.pixel.x += 1;
  rays.want(scene, camera, ask);
  EXPECT_FALSE(rays.inspection()->modes[1]) << "of another ray nothing is";
  rays.clear();
  EXPECT_FALSE(rays.is_busy());
}

TEST_F(RayInspectorTest, TheExactMarchHasNoSteps) {
  scene.rendering.classification = ClassificationMethod::analytic;
  rays.want(scene, camera, ask);
  while (rays.is_busy()) rays.work(renderer);
  EXPECT_TRUE(rays.inspection()->modes[0]->steps.empty());
  EXPECT_NE(rays.inspection()->modes[0]->why_no_steps, "");
}

TEST_F(RayInspectorTest, WhatCannotBeSolvedIsNotTheRayOfAnEarlierScene) {
  rays.want(scene, camera, ask);
  while (rays.is_busy()) rays.work(renderer);
  camera.target = camera.eye;  // no picture
  rays.want(scene, camera, ask);
  for (int i = 0; i < view_count; ++i) rays.work(renderer);
  EXPECT_FALSE(rays.is_busy()) << "it is not tried again";
  for (std::size_t i = 0; i < view_count; ++i) {
    EXPECT_FALSE(rays.inspection()->modes[i]);
    EXPECT_NE(rays.inspection()->errors[i], "");
  }
}

TEST_F(RayInspectorTest, TheTableHasARowForEachPlaceAndStep) {
  rays.want(scene, camera, ask);
  while (rays.is_busy()) rays.work(renderer);
  const std::string table = ray_table(*rays.inspection());
  std::size_t rows = 1;
  for (const auto& ray : rays.inspection()->modes) rows += ray->exact.places.size() + ray->steps.size();
  EXPECT_EQ(std::size_t(std::ranges::count(table, '\n')), rows);
  EXPECT_TRUE(
      table.starts_with("mode,kind,depth,value,surface,opacity,red,green,blue,crossings\nDVR_ONLY,exact,"));
}

TEST_F(RayInspectorTest, PicksWhatThePixelShows) {
  scene.rendering.mode = Mode::peak_only;
  const PickedPixel picked = rays.pick(scene, camera, ask);
  EXPECT_EQ(picked.ask, ask);
  ASSERT_TRUE(picked.picked.surface);
  const auto peaks = find_peaks(scene.tf);
  EXPECT_TRUE(std::ranges::any_of(
      peaks, [&](const Peak& peak) { return std::abs(peak.value - *picked.picked.surface) < 1e-6; }));
}

}  // namespace
}  // namespace crest
