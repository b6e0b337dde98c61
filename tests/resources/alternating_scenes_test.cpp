// One renderer, scene after scene: what a scene needs is made once, however often another comes between.
#include "render/renderer.h"

#include <limits>

#include "presets/preset_file.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

std::shared_ptr<const Volume> gyroid(bool with_holes) {
  Volume volume = make_builtin("gyroid?n=16");
  if (with_holes)
    for (const std::size_t index : {300u, 301u, 800u}) volume.values.floats()[index] = std::nanf("");
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

class AlternatingScenes : public RaycasterTest {
 protected:
  Scene scene_of(const std::shared_ptr<const Volume>& volume, Mode mode, const char* preset = "four-peaks") {
    Scene scene = make_scene(volume, load_preset(preset));
    scene.rendering.mode = mode;
    return scene;
  }
  Image draw(const Scene& scene) {
    gl::RenderTarget target({16, 16}, false);
    renderer.draw(scene, whole_volume_camera(scene.volume->grid, 1), target);
    return target.read_color();
  }
  /// Draws the scenes in turn: nothing is made after the first turn, and each picture stays the same to the
  /// bit.
  void expect_made_once(const std::vector<Scene>& scenes) {
    std::vector<Image> first;
    for (const Scene& scene : scenes) first.push_back(draw(scene));
    const int made = renderer.resources().held.made();
    EXPECT_GT(made, 0);
    for (int turn = 0; turn < 3; ++turn)
      for (std::size_t i = 0; i < scenes.size(); ++i)
        EXPECT_EQ(draw(scenes[i]).pixels, first[i].pixels) << "turn " << turn << ", scene " << i;
    EXPECT_EQ(renderer.resources().held.made(), made);
  }

  Renderer renderer;
};

TEST_F(AlternatingScenes, TheFourModes) {
  const auto volume = gyroid(false);
  expect_made_once({scene_of(volume, Mode::both), scene_of(volume, Mode::dvr_only),
                    scene_of(volume, Mode::peak_only), scene_of(volume, Mode::peak_xor_dvr)});
}

// The surfaces' filter reaches further than the samples': each mode has empty cells of another radius.
TEST_F(AlternatingScenes, FiltersOverEmptyCells) {
  const auto volume = gyroid(true);
  std::vector<Scene> scenes{scene_of(volume, Mode::dvr_only), scene_of(volume, Mode::both),
                            scene_of(volume, Mode::dvr_only)};
  for (const std::size_t i : {0u, 1u}) scenes[i].rendering.root_filter = Filter::bspline;
  expect_made_once(scenes);
}

TEST_F(AlternatingScenes, StepsOfThePreintegrationTable) {
  std::vector<Scene> scenes(2, scene_of(gyroid(false), Mode::dvr_only));
  for (Scene& scene : scenes) {
    scene.rendering.classification = ClassificationMethod::preintegrated_table;
    scene.rendering.placement = Placement::entry;
  }
  scenes[1].rendering.step = 2;
  expect_made_once(scenes);
}

TEST_F(AlternatingScenes, VolumesAndTransferFunctions) {
  const auto a = gyroid(false), b = gyroid(true);
  expect_made_once({scene_of(a, Mode::both), scene_of(b, Mode::both), scene_of(a, Mode::both, "onion"),
                    scene_of(b, Mode::dvr_only, "smooth-haze")});
}

// The second engine reads the first one's volume, and its TF.
TEST_F(AlternatingScenes, BothEnginesHoldOneVolume) {
  const auto volume = gyroid(false);
  Scene scene = scene_of(volume, Mode::dvr_only, "smooth-haze");
  scene.rendering.skipping = false;
  draw(scene);
  const std::size_t bytes = renderer.resources().held.bytes();
  const int made = renderer.resources().held.made();
  scene.rendering.engine = Engine::vdls;
  draw(scene);
  EXPECT_LT(renderer.resources().held.bytes(), bytes + volume->grid.point_count());
  EXPECT_EQ(renderer.resources().held.made(), made);
}

TEST_F(AlternatingScenes, NothingIsUploadedToClassify) {
  renderer.classification(scene_of(gyroid(false), Mode::both));
  EXPECT_EQ(renderer.resources().held.count(), 1u);
}

TEST_F(AlternatingScenes, WhatIsOfAVolumeGoesWithIt) {
  auto volume = gyroid(false);
  draw(scene_of(volume, Mode::both));
  const std::size_t points = volume->grid.point_count(), bytes = renderer.resources().held.bytes();
  volume.reset();
  renderer.resources().held.begin_round();
  EXPECT_LE(renderer.resources().held.bytes() + points * sizeof(float), bytes);
}

}  // namespace
}  // namespace crest::testing
