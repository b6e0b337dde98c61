#include <cmath>

#include "presets/names.h"
#include "tests/vdls/fixture.h"

namespace crest::testing {
namespace {

class Filters : public VdlsTest {
 protected:
  glm::vec4 pixel(const Scene& scene, Engine engine) {
    return render(scene, along_z(scene.volume->grid, 16), {9, 9}, engine).at(4, 4);
  }
};

/// A ramp from 0 to 1 over 16 voxels, with an opacity of 0.4 between a quarter and three quarters of it.
Scene slab() {
  const Grid grid{glm::ivec3(17), glm::dvec3(1), glm::dvec3(0)};
  Scene scene{make_volume(grid, [](glm::dvec3 p) { return p.z / 16; }),
              make_tf({point(0, 0), point(0.25, 0), point(0.25, 0.4, {1, 0.5, 0}),
                       point(0.75, 0.4, {1, 0.5, 0}), point(0.75, 0), point(1, 0)},
                      4),
              {}};
  scene.rendering.mode = Mode::dvr_only;
  return scene;
}

// Each filter in both engines against what Table 1 says of a ramp.
TEST_F(Filters, AreTheirFormulas) {
  for (const Engine engine : {Engine::raycaster, Engine::vdls})
    for (const int n : {16, 32}) {
      Scene scene = slab();
      scene.rendering.step = 16.0 / n * (1 + 1e-5);
      const auto shown = [&](BlendMode blend_mode) {
        scene.rendering.blend_mode = blend_mode;
        return pixel(scene, engine);
      };
      const auto expect = [&](BlendMode blend_mode, glm::dvec4 expected) {
        const glm::vec4 found = shown(blend_mode);
        for (int channel = 0; channel < 4; ++channel)
          EXPECT_NEAR(found[channel], expected[channel], 2e-6)
              << name_of(engine) << ' ' << n << ' ' << name_of(blend_mode) << ' ' << channel;
      };
      const double clear = std::pow(0.6, 8.0 / 4), stacked = std::pow(0.6, n / 2);
      expect(BlendMode::semi_transparent, {1 - clear, 0.5 * (1 - clear), 0, 1 - clear});
      expect(BlendMode::lookup, {1 - stacked, 0.5 * (1 - stacked), 0, 1 - stacked});
      expect(BlendMode::iso_surface, glm::dvec4(1));
      expect(BlendMode::maximum, {glm::dvec3(1 - 0.5 / n), 1});
      expect(BlendMode::minimum, {glm::dvec3(0.5 / n), 1});
      expect(BlendMode::mean, {glm::dvec3(0.5), 1});
    }
}

// In both engines alike, whatever the speed-ups and the order; pixels beside the volume stay empty.
TEST_F(Filters, BothEnginesShowTheSame) {
  Scene scene = dvr_scene(builtin("gyroid?n=20"), "smooth-haze");
  scene.rendering.shading = Shading::gradient;
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  VdlsOptions direct, backwards = VdlsOptions::basic();
  backwards.back_to_front = true;
  backwards.layers_per_pass = 3;
  direct.gradient_volume = backwards.gradient_volume = false;
  for (const auto& [blend_mode, name] : names_of<BlendMode>())
    for (const VdlsOptions& options : {direct, backwards}) {
      scene.rendering.blend_mode = blend_mode;
      EXPECT_LT(difference(scene, camera, options), 2 * rounding) << name;
      EXPECT_EQ(render(scene, camera, {40, 40}, Engine::vdls).at(0, 0), glm::vec4(0)) << name;
    }
}

// In the ray caster each filter joins its passes, steps of any kind, and says what it leaves out.
TEST_F(Filters, JoinThePassesOfLongRays) {
  Scene scene = dvr_scene(builtin("gyroid?n=20"), "smooth-haze", 0.25);
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  for (const auto& [blend_mode, name] : names_of<BlendMode>()) {
    scene.rendering.blend_mode = blend_mode;
    renderer.raycaster().force({});
    const Image once = render(scene, camera, {40, 40}, Engine::raycaster);
    Forced forced;
    forced.intervals_per_pass = 11;
    renderer.raycaster().force(forced);
    EXPECT_LT(largest_difference(render(scene, camera, {40, 40}, Engine::raycaster), once), rounding) << name;
  }
}

// An iso-surface leaps over what is beyond its half height.
TEST_F(Filters, IsoSurfacesLeapFurther) {
  Scene scene{builtin("sphere?n=24"), {}, {}};
  const ValueRange range = scene.volume->statistics.range;
  const auto value = [&](double share) { return range.min + share * range.width(); };
  scene.tf = make_tf({point(value(0), 0), point(value(0.3), 0), point(value(1), 0.8)});
  scene.rendering.mode = Mode::dvr_only;
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  const auto samples = [&](BlendMode blend_mode) {
    scene.rendering.blend_mode = blend_mode;
    EXPECT_LT(difference(scene, camera, {}), rounding);
    return sum_of(counts(scene, camera, {40, 40}, Engine::vdls)).samples;
  };
  const double soft = samples(BlendMode::semi_transparent), all = samples(BlendMode::maximum);
  EXPECT_LT(samples(BlendMode::iso_surface), 0.9 * soft);
  EXPECT_LE(soft, all);
}

}  // namespace
}  // namespace crest::testing
