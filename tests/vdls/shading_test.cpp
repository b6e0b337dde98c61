#include "tests/vdls/fixture.h"

namespace crest::testing {
namespace {

using ShadedLayers = VdlsTest;

/// Shells around the middle of a field whose gradient has length 1 there, and which ends in no shell.
Scene shells() {
  const Grid grid{glm::ivec3(24), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return glm::length(p - 11.5); });
  Scene scene{volume,
              make_tf({point(0, 0), point(4, 0), point(5, 0.3, {1, 0.5, 0.2}), point(6, 0), point(8, 0.2),
                       point(9, 0.4), point(10, 0)}),
              {}};
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.shading = Shading::gradient;
  return scene;
}

// With the ray caster's own gradients the pictures are the same, also in the box's faces, where they are
// one-sided.
TEST_F(ShadedLayers, SameGradientsSamePicture) {
  const Scene haze = [] {
    Scene scene = dvr_scene(builtin("gyroid?n=20"), "smooth-haze");
    scene.rendering.shading = Shading::gradient;
    return scene;
  }();
  for (const Scene& scene : {shells(), haze})
    for (VdlsOptions options : {VdlsOptions{}, VdlsOptions::basic()}) {
      options.gradient_volume = false;
      EXPECT_LT(difference(scene, whole_volume_camera(scene.volume->grid, 1), options), 2 * rounding);
    }
}

// Each component is off by half a code at most, so the gradient by sqrt(3)/2 codes, its direction by twice
// that over its length, and the light by the diffuse share of that. A picture's colour is a mean of lights.
TEST_F(ShadedLayers, QuantisedGradientsKeepTheirBound) {
  const Scene scene = shells();
  constexpr double diffuse = 0.75, codes = 32767, least_gradient = 0.95;
  const double bound = diffuse * std::sqrt(3.0) / (codes * least_gradient) + 2 * rounding;
  EXPECT_LT(bound, 1e-4);
  Scene unshaded = scene;
  unshaded.rendering.shading = Shading::none;
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  EXPECT_LT(difference(scene, camera, {}), bound);
  EXPECT_GT(largest_difference(render(scene, camera, {40, 40}, Engine::vdls),
                               render(unshaded, camera, {40, 40}, Engine::vdls)),
            0.1);
}

// Where the field is flat there is full light, as in the ray caster.
TEST_F(ShadedLayers, FlatFieldsAreFullyLit) {
  const Grid grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return p.x < 7 ? 1.0 : 2.0; });
  Scene scene{volume, make_tf({point(0, 0.2), point(1.1, 0.2), point(1.2, 0), point(2, 0)}), {}};
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.shading = Shading::gradient;
  scene.rendering.clip_box = ClipBox{{0, 0, 0}, {5, 8, 8}, ""};
  EXPECT_LT(difference(scene, whole_volume_camera(grid, 1), {}), rounding);
}

}  // namespace
}  // namespace crest::testing
