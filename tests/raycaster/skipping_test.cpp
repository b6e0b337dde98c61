// Empty space is skipped, and nothing else changes.
#include <algorithm>
#include <cmath>

#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

class Skipping : public RaycasterTest {
 protected:
  void SetUp() override {
    Forced forced;
    forced.features.skipping = true;  // also where it does not pay
    raycaster.force(forced);
  }
  /// The most that a pixel of the scene changes with skipping.
  double difference(Scene scene, const Camera& camera, glm::ivec2 size = {24, 24}) {
    scene.rendering.skipping = true;
    const Image with = render(scene, camera, size);
    EXPECT_TRUE(raycaster.features(scene, false).skipping);
    raycaster.force({});
    scene.rendering.skipping = false;
    const Image without = render(scene, camera, size);
    SetUp();
    return largest_difference(with, without);
  }
};

Volume holed_gyroid() {
  Volume volume = make_builtin("gyroid?n=24");
  for (const std::size_t index : {3000u, 3001u, 8000u, 11111u}) volume.values.floats()[index] = NAN;
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return volume;
}

TEST_F(Skipping, LeavesThePictureAsItIs) {
  const std::shared_ptr<const Volume> volumes[] = {
      std::make_shared<Volume>(make_builtin("plume?n=40")),
      std::make_shared<Volume>(make_builtin("vessels?n=48")),
      std::make_shared<Volume>(make_builtin("marschner-lobb?n=33")),
      std::make_shared<Volume>(holed_gyroid()),
  };
  for (const auto& volume : volumes)
    for (const char* preset : {"vessels-shell", "four-peaks"}) {
      Scene scene = make_scene(volume, load_preset(preset));
      const Camera camera = whole_volume_camera(volume->grid, 1);
      for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::peak_only, Mode::dvr_only})
        for (const PeakForm form : {PeakForm::split, PeakForm::paper}) {
          scene.rendering.mode = mode;
          scene.rendering.peak_form = form;
          EXPECT_LT(difference(scene, camera), 2e-6f)
              << volume->name << ' ' << preset << ' ' << name_of(mode) << ' ' << name_of(form);
        }
    }
}

TEST_F(Skipping, HoldsForEverySamplingAndStep) {
  const auto volume = std::make_shared<const Volume>(make_builtin("vessels?n=48"));
  Scene scene = make_scene(volume, load_preset("vessels-shell"));
  scene.rendering.mode = Mode::peak_xor_dvr;
  Camera camera = whole_volume_camera(volume->grid, 1);
  for (const bool inside : {false, true}) {
    if (inside) camera.eye = glm::mix(camera.eye, camera.target, 0.9);
    for (const double step : {0.05, 0.4, 3.0, 20.0})
      for (const Placement placement : {Placement::eye, Placement::entry, Placement::entry_exit_corner}) {
        scene.rendering.step = step;
        scene.rendering.placement = placement;
        EXPECT_LT(difference(scene, camera), 2e-6f) << step << ' ' << name_of(placement) << ' ' << inside;
      }
    for (const Sampling sampling : {Sampling::differential, Sampling::footprint})
      for (const double s_k : {0.3, 4.0}) {
        scene.rendering.sampling = sampling;
        scene.rendering.s_k = s_k;
        EXPECT_LT(difference(scene, camera), 2e-6f) << name_of(sampling) << ' ' << s_k << ' ' << inside;
      }
    scene.rendering.sampling = Sampling::uniform;
  }
}

// Also where a ray takes several passes, and where adaptive sampling leaves out what is empty.
TEST_F(Skipping, HoldsInPassesAndWithJoinedSteps) {
  const auto volume = std::make_shared<const Volume>(make_builtin("vessels?n=48"));
  Scene scene = make_scene(volume, load_preset("vessels-shell"));
  scene.rendering.mode = Mode::peak_xor_dvr;
  const Camera camera = whole_volume_camera(volume->grid, 1);
  Forced forced;
  forced.features.skipping = forced.features.long_rays = true;
  forced.intervals_per_pass = 37;
  const Image plain = render(scene, camera, {40, 40});
  raycaster.force(forced);
  EXPECT_LT(largest_difference(plain, render(scene, camera, {40, 40})), 2e-6f);

  scene.rendering.adaptive = true;
  SetUp();
  const Image joined = render(scene, camera, {40, 40});
  raycaster.force(forced);
  EXPECT_LT(largest_difference(joined, render(scene, camera, {40, 40})), 2e-6f);
}

// No sample is taken twice where cells meet: with every cell occupied there are as many as without skipping.
TEST_F(Skipping, TakesNoSampleTwice) {
  const auto volume = std::make_shared<const Volume>(make_builtin("plume?n=40"));
  Scene scene = make_scene(volume, load_preset("smooth-haze"));
  for (ControlPoint& point : scene.tf.points) point.opacity = std::max(point.opacity, 0.01);
  const Camera camera = whole_volume_camera(volume->grid, 1);
  for (const Mode mode : {Mode::both, Mode::dvr_only}) {
    scene.rendering.mode = mode;
    const RenderCounts with = count(scene, camera);
    raycaster.force({});
    const RenderCounts without = count(scene, camera);
    SetUp();
    EXPECT_EQ(with.samples, without.samples);
    EXPECT_EQ(with.dvr_samples, without.dvr_samples);
    EXPECT_EQ(with.crossings, without.crossings);
  }
}

TEST_F(Skipping, SkipsWhatIsEmpty) {
  const auto volume = std::make_shared<const Volume>(make_builtin("vessels?n=64"));
  Scene scene = make_scene(volume, load_preset("vessels-shell"));
  const Camera camera = whole_volume_camera(volume->grid, 1);
  raycaster.force({});
  const double with = count(scene, camera, {64, 64}).samples;
  scene.rendering.skipping = false;
  EXPECT_LT(with, 0.5 * count(scene, camera, {64, 64}).samples);
}

}  // namespace
}  // namespace crest::testing
