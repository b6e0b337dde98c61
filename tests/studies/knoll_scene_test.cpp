#include "render/studies/knoll/scene.h"

#include <gtest/gtest.h>

#include "presets/error.h"
#include "presets/peaks.h"
#include "presets/preset_file.h"
#include "render/raycaster/step_lengths.h"
#include "render/studies/knoll/variants.h"
#include "render/volume/builtin.h"

namespace crest::testing {
namespace {

KnollScene small_scene() {
  KnollScene scene;
  const auto volume = std::make_shared<const Volume>(make_builtin("sphere?n=8"));
  scene.scene = make_scene(volume, load_preset("dirac-shell"));
  return scene;
}

TEST(KnollScene, SettingsAreFieldsOfTheRendering) {
  const Rendering rendering = with_settings({}, "mode=DVR_ONLY sampling=differential s_k=0.25");
  EXPECT_EQ(rendering.mode, Mode::dvr_only);
  EXPECT_EQ(rendering.sampling, Sampling::differential);
  EXPECT_EQ(rendering.s_k, 0.25);
  EXPECT_EQ(rendering.skipping, Rendering{}.skipping);
  EXPECT_EQ(with_settings(rendering, ""), rendering);
  EXPECT_THROW(with_settings({}, "mode=DVR_ONLY bogus=1"), Error);
}

TEST(KnollScene, MeasuredWithoutShadingAndEarlyTermination) {
  KnollScene scene = small_scene();
  scene.scene.rendering.early_termination = 0.01;
  const Scene measured = measured_scene(scene, {"post", "", "mode=DVR_ONLY"});
  EXPECT_EQ(scene.scene.rendering.shading, Shading::gradient);
  EXPECT_EQ(measured.rendering.shading, Shading::none);
  EXPECT_EQ(measured.rendering.early_termination, 0);
  EXPECT_EQ(measured.tf, scene.scene.tf);
}

// The points keep their opacity: only what a crossing absorbs grows.
TEST(KnollScene, AGainMultipliesSurfacesAlone) {
  const KnollScene scene = small_scene();
  const auto surface = [](const TransferFunction& tf) { return shown_peaks(find_peaks(tf)).at(0); };
  const double own = surface(scene.scene.tf).opacity;
  const TransferFunction half = measured_scene(scene, {"", "", "", 0.5}).tf;
  EXPECT_EQ(surface(half).opacity, own / 2);
  EXPECT_EQ(surface(half).value, surface(scene.scene.tf).value);
  for (std::size_t i = 0; i < half.points.size(); ++i)
    EXPECT_EQ(half.points[i].opacity, scene.scene.tf.points[i].opacity);
  EXPECT_EQ(surface(measured_scene(scene, {"", "", "", 16}).tf).opacity, 1);
}

TEST(KnollScene, AViewIsInUnitsOfTheBox) {
  const Grid grid{glm::ivec3(11, 21, 31), glm::dvec3(2, 1, 1), glm::dvec3(100, 0, 0)};
  const Camera camera = camera_in_box(grid, {{1, -2, 0}, {0, 0, 1}, {0, 0, 1}, 40});
  EXPECT_EQ(camera.eye, glm::dvec3(120, -10, 15));
  EXPECT_EQ(camera.target, glm::dvec3(110, 10, 30));
  EXPECT_EQ(camera.fov_y_degrees, 40);
}

TEST(KnollVariants, AreSettingsThatThereAre) {
  std::vector<Variant> all = table1_variants(1);
  for (const auto& more : {bins_variants(1), sampling_methods(),
                           std::vector{preintegrated_table_variant(0.5), surfaces_variant(1),
                                       single_peak_variant(1), magnified_variant(1), post_bspline_method()}})
    all.insert(all.end(), more.begin(), more.end());
  for (const Variant& variant : all) EXPECT_NO_THROW(with_settings({}, variant.settings)) << variant.id;
  EXPECT_EQ(with_settings({}, table1_variants(1).front().settings).mode, Mode::dvr_only)
      << "to which the others' times are put in ratio";
}

// A ray takes as many steps, of the same lengths, whatever the picture's width.
TEST(KnollVariants, TheSameStepsAtEveryWidth) {
  EXPECT_EQ(s_k_of_paper(paper_width), 4);
  const Grid grid{glm::ivec3(256), glm::dvec3(1), glm::dvec3(0)};
  const Camera camera = camera_in_box(grid, {{0.3, -4, 0.2}, {0, 0, 0}, {0, 0, 1}, 30});
  const Box box{grid.box_min(), grid.box_max()};
  Rendering rendering = with_settings({}, "sampling=differential");
  const StepLengths wanted = step_lengths(rendering, camera, glm::ivec2(paper_width), box, grid);
  for (const int width : {64, 256, 2048}) {
    rendering.s_k = s_k_of_paper(width);
    const StepLengths steps = step_lengths(rendering, camera, glm::ivec2(width), box, grid);
    EXPECT_NEAR(steps.most / wanted.most, 1, 0.02) << width;
    EXPECT_NEAR(steps.longest / wanted.longest, 1, 0.02) << width;
  }
}

}  // namespace
}  // namespace crest::testing
