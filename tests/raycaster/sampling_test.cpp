// Steps whose length varies along the ray: differential, footprint, adaptive.
#include <algorithm>
#include <cmath>

#include "presets/error.h"
#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/measure/image_error.h"
#include "render/raycaster/step_lengths.h"
#include "render/reference/reference.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

constexpr double depth = 40;

/// Two points across, so that the field depends on z alone: z / depth.
std::shared_ptr<const Volume> ramp() {
  return make_volume(Grid{glm::ivec3(41), glm::dvec3(1), glm::dvec3(0)},
                     [](glm::dvec3 p) { return p.z / depth; });
}

/// One pixel's ray along z from `before` the box; the picture is as wide as one of 512 pixels would show it.
Camera camera_from(double before) {
  Camera camera;
  camera.eye = {20, 20, -before};
  camera.target = {20, 20, depth};
  camera.up = {0, 1, 0};
  camera.fov_y_degrees = 60;
  return camera;
}

/// What the papers' formulas say of the middle ray of a picture of one pixel; in parallel projection nothing
/// grows.
struct Boundaries {
  Sampling sampling;
  double k, spread;

  double at(double x) const {  // from the eye
    if (spread == 0) return k * x;
    if (sampling == Sampling::footprint) return std::pow(1 + k, x) - 1;
    return k * x + k * spread * x * (x - 1) / 2;
  }
};

Boundaries boundaries_of(const Camera& camera, const Rendering& rendering) {
  const double half = std::tan(glm::radians(camera.fov_y_degrees / 2));  // a pixel's side, and its width
  if (camera.projection == Projection::perspective)
    return {rendering.sampling, rendering.s_k * half * std::sqrt(8.0), half};
  const double distance = glm::length(camera.target - camera.eye);
  return {rendering.sampling, rendering.s_k * half * distance * std::sqrt(8.0), 0};
}

class VaryingSteps : public RaycasterTest {
 protected:
  Scene scene{ramp(), make_tf({point(0, 0.2), point(1, 0.2)}, 8), {}};
};

// Segments tile the ray, whatever their sizes: a constant medium comes out exactly.
TEST_F(VaryingSteps, TileTheRay) {
  for (const Mode mode : {Mode::dvr_only, Mode::both})
    for (const Sampling sampling : {Sampling::uniform, Sampling::differential, Sampling::footprint})
      for (const bool adaptive : {false, true})
        for (const double s_k : {0.05, 1.0, 40.0})
          for (const double before : {0.0, 3.3, 1000.0, -7.0}) {
            scene.rendering.mode = mode;
            scene.rendering.sampling = sampling;
            scene.rendering.adaptive = adaptive;
            scene.rendering.s_k = s_k;
            const Image image = render(scene, camera_from(before), {3, 3});
            EXPECT_NEAR(image.at(1, 1).a, 1 - std::pow(0.8, (depth + std::min(before, 0.0)) / 8), 2e-6)
                << name_of(mode) << ' ' << name_of(sampling) << ' ' << adaptive << ' ' << s_k << ' '
                << before;
          }
}

// The boundaries are where the formulas say: as many samples, each the field's value in its segment's middle.
TEST_F(VaryingSteps, LieWhereTheFormulasSay) {
  scene.tf = make_tf({point(0, 1e-3, glm::dvec3(0)), point(1, 1e-3, glm::dvec3(1))}, 1);
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.shading = Shading::none;
  const double rho = -std::log1p(-1e-3);
  for (const Sampling sampling : {Sampling::differential, Sampling::footprint})
    for (const double s_k : {0.01, 0.1, 0.37, 2.0})
      for (const double before : {0.0, 5.5, 77.7}) {
        scene.rendering.sampling = sampling;
        scene.rendering.s_k = s_k;
        const Camera camera = camera_from(before);
        const Boundaries boundaries = boundaries_of(camera, scene.rendering);
        double color = 0, transmittance = 1, from = before;
        int segments = 0;
        for (int x = 1; from < before + depth; ++x) {
          const double to = std::min(boundaries.at(x), before + depth);
          if (to <= from) continue;
          const double alpha = -std::expm1(-rho * (to - from));
          color += transmittance * alpha * ((from + to) / 2 - before) / depth;
          transmittance *= 1 - alpha;
          from = to;
          ++segments;
        }
        const std::string what =
            std::string(name_of(sampling)) + ' ' + std::to_string(s_k) + ' ' + std::to_string(before);
        EXPECT_NEAR(this->count(scene, camera, {1, 1}).dvr_samples, segments, 1) << what;
        EXPECT_NEAR(render(scene, camera, {1, 1}).at(0, 0).r, color, 2e-6) << what;
      }
}

// From a million diagonals away a constant medium is the same; from where differential steps would be
// millions, a person is told so.
TEST_F(VaryingSteps, HoldFarAway) {
  Camera camera = camera_from(7e7);
  camera.fov_y_degrees = 2e-5;
  for (const Sampling sampling : {Sampling::differential, Sampling::footprint}) {
    scene.rendering.sampling = sampling;
    EXPECT_NEAR(render(scene, camera, {3, 3}).at(1, 1).a, 1 - std::pow(0.8, depth / 8), 2e-5)
        << name_of(sampling);
  }
  camera = camera_from(1e20);
  camera.fov_y_degrees = 1e-17;
  EXPECT_NO_THROW(render(scene, camera, {3, 3}));
  scene.rendering.sampling = Sampling::differential;
  EXPECT_THROW(render(scene, camera, {3, 3}), Error);
}

// Where no pixel grows, all steps are alike: s_k pixels' diagonals.
TEST_F(VaryingSteps, AreAlikeInParallelProjection) {
  scene.tf = make_tf({point(0, 1e-3, glm::dvec3(0)), point(1, 1e-3, glm::dvec3(1))}, 1);
  scene.rendering.mode = Mode::dvr_only;
  Camera camera = camera_from(3);
  camera.projection = Projection::parallel;
  for (const Sampling sampling : {Sampling::differential, Sampling::footprint})
    for (const bool adaptive : {false, true})
      for (const double s_k : {0.005, 0.02, 0.1}) {
        scene.rendering.sampling = sampling;
        scene.rendering.adaptive = adaptive;
        scene.rendering.s_k = s_k;
        const double k = boundaries_of(camera, scene.rendering).k, steps = depth / k;
        const std::string what = std::string(name_of(sampling)) + ' ' + std::to_string(s_k);
        if (!adaptive) {
          EXPECT_NEAR(this->count(scene, camera, {1, 1}).dvr_samples, steps, 2)
              << what;  // it begins and ends in one
        }
        const double light = -std::expm1(depth * std::log1p(-1e-3));
        EXPECT_NEAR(render(scene, camera, {1, 1}).at(0, 0).a, light, 2e-6) << what;
      }
  scene.rendering.s_k = 0.001;
  camera.fov_y_degrees = 1e-5;
  EXPECT_THROW(render(scene, camera, {1, 1}), Error) << "steps so short that a ray would take millions";
}

/// RMSE of the scene's picture against the exact one.
double error_of(const Image& image, const Reference& exact) {
  return image_error(exact, image, {}, glm::vec3(0)).compared.rmse;
}

// The paper's implementation got worse for small s_k, which its authors put down to 32-bit float (section 8).
// Here the error falls with s_k to the floor that rounding sets, and stays there.
TEST_F(VaryingSteps, SmallerStepsAreNeverWorse) {
  const auto plume = std::make_shared<const Volume>(make_builtin("plume?n=32"));
  Preset preset = load_preset("smooth-haze");
  for (const Sampling sampling : {Sampling::differential, Sampling::footprint}) {
    Scene close = make_scene(plume, preset);
    close.rendering.mode = Mode::dvr_only;
    close.rendering.sampling = sampling;
    Camera camera = whole_volume_camera(plume->grid, 1);
    camera.eye = glm::mix(camera.eye, camera.target, 0.6);
    const glm::ivec2 size(128);
    const Reference exact = render_reference(close, camera, size, Answer::integral);
    double first = 0, before = 1;
    for (double s_k = 12.8; s_k > 0.04; s_k /= 2) {
      close.rendering.s_k = s_k;
      const double error = error_of(render(close, camera, size), exact);
      printf("%s, s_k %.2f: RMSE %.3g\n", std::string(name_of(sampling)).c_str(), s_k, error);
      EXPECT_LT(error, before) << name_of(sampling) << ' ' << s_k;
      before = error;
      if (first == 0) first = error;
    }
    const double order = std::log2(first / before) / 8;
    EXPECT_NEAR(order, sampling == Sampling::differential ? 1 : 2, 0.2);
  }
}

// With adaptive sampling a step is longer where the field is smooth, and as before where it is not: fewer
// samples.
TEST_F(VaryingSteps, AdaptiveTakesFewerSamplesForALittleMoreError) {
  const auto plume = std::make_shared<const Volume>(make_builtin("plume?n=64"));
  Scene adaptive = make_scene(plume, load_preset("smooth-haze"));
  adaptive.rendering.mode = Mode::dvr_only;
  const Camera camera = whole_volume_camera(plume->grid, 1);
  const glm::ivec2 size(64);
  const Reference exact = render_reference(adaptive, camera, size, Answer::integral);
  const Scene plain = adaptive;
  adaptive.rendering.adaptive = true;
  EXPECT_LT(count(adaptive, camera, size).dvr_samples, 0.85 * count(plain, camera, size).dvr_samples);
  Scene coarse = plain;  // as many samples, all equally far apart
  coarse.rendering.step *= count(plain, camera, size).dvr_samples / count(adaptive, camera, size).dvr_samples;
  const double error = error_of(render(adaptive, camera, size), exact);
  printf("RMSE: equal steps %.3g, adaptive %.3g, as many equal ones %.3g\n",
         error_of(render(plain, camera, size), exact), error, error_of(render(coarse, camera, size), exact));
  EXPECT_LT(error, error_of(render(coarse, camera, size), exact));
}

}  // namespace
}  // namespace crest::testing
