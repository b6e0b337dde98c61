#include <array>
#include <cmath>

#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

Grid cube(int n) { return Grid{glm::ivec3(n), glm::dvec3(1), glm::dvec3(0)}; }

Scene scene_of(std::shared_ptr<const Volume> volume, TransferFunction tf, Mode mode,
               PeakForm form = PeakForm::split) {
  Scene scene{std::move(volume), std::move(tf), {}};
  scene.rendering.mode = mode;
  scene.rendering.peak_form = form;
  return scene;
}

constexpr Mode all_modes[] = {Mode::both, Mode::peak_xor_dvr, Mode::peak_only, Mode::dvr_only};

using ClosedForm = RaycasterTest;

// A slab of one material absorbs 1-(1-a)^(length/unit), in every mode with DVR and at every step.
TEST_F(ClosedForm, ConstantSlab) {
  const auto volume = make_volume(cube(9), [](glm::dvec3) { return 0.5; });
  const auto tf = make_tf({point(0, 0.3, {1, 0.5, 0.25}), point(1, 0.3, {1, 0.5, 0.25})}, 4.0);
  const double opacity = 1 - std::pow(0.7, 8.0 / 4.0);
  for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::dvr_only})
    for (const double step : {8.0, 1.0, 0.37, 1.0 / 64}) {
      Scene scene = scene_of(volume, tf, mode);
      scene.rendering.step = step;
      const glm::vec4 pixel = render(scene, along_z(volume->grid, 8)).at(8, 8);
      EXPECT_NEAR(pixel.a, opacity, 2e-6) << step;
      EXPECT_NEAR(pixel.r, opacity, 2e-6);
      EXPECT_NEAR(pixel.g, 0.5 * opacity, 2e-6);
      EXPECT_NEAR(pixel.b, 0.25 * opacity, 2e-6);
    }
}

// Along a linear field through a linear extinction the optical depth is that of the mean value, exactly for
// midpoint samples of the opacity's own curve only in the limit: the error falls with the square of the step.
TEST_F(ClosedForm, RampConvergesWithTheSquareOfTheStep) {
  const auto volume = make_volume(cube(17), [](glm::dvec3 p) { return p.z / 16; });
  const auto tf = make_tf({point(0, 0), point(1, 0.9)}, 4.0);
  // depth = integral over [0,16] of -ln(1-0.9 z/16)/4 dz = 16/4 * ((1-u) ln(1-u) + u)/u at u = 0.9
  const double u = 0.9, depth = 16.0 / 4.0 * ((1 - u) * std::log1p(-u) + u) / u;
  double previous = 0;
  for (const double step : {4.0, 2.0, 1.0}) {
    Scene scene = scene_of(volume, tf, Mode::dvr_only);
    scene.rendering.step = step;
    const double error =
        std::abs(double(render(scene, along_z(volume->grid, 16)).at(8, 8).a) + std::expm1(-depth));
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / error), 2.0, 0.2) << step;
    }
    previous = error;
  }
}

// A surface has its own opacity, whatever the step, the unit distance and the width of its peak.
TEST_F(ClosedForm, PlanesHaveExactlyTheirOpacity) {
  const auto volume = make_volume(cube(17), [](glm::dvec3 p) { return p.z / 16; });
  for (const double width : {1e-1, 1e-4, 1e-9, 0.0})
    for (const double step : {16.0, 1.0, 0.13})
      for (const PeakForm form : {PeakForm::split, PeakForm::paper}) {
        const auto tf = make_tf({point(0, 0), point(0.3 - width, 0), point(0.3, 0.6, {1, 0, 0}),
                                 point(0.3 + width, 0), point(1, 0)});
        Scene scene = scene_of(volume, tf, Mode::peak_only, form);
        scene.rendering.step = step;
        const glm::vec4 pixel = render(scene, along_z(volume->grid, 16)).at(3, 5);
        EXPECT_NEAR(pixel.a, 0.6, 1e-6) << width << ' ' << step;
        EXPECT_NEAR(pixel.r, 0.6, 1e-6);
        EXPECT_EQ(pixel.g, 0.f);
      }
}

// Four surfaces within one step are met in their order, from either side, and the first has most of the
// colour.
TEST_F(ClosedForm, FourPeaksInOneStepInTheirOrder) {
  const glm::dvec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  std::vector<ControlPoint> points{point(0, 0)};
  for (int i = 0; i < 4; ++i) {
    const double v = 0.4 + 0.05 * i;
    points.insert(points.end(),
                  {point(v - 1e-3, 0, colors[i]), point(v, 0.5, colors[i]), point(v + 1e-3, 0, colors[i])});
  }
  points.push_back(point(1, 0));
  for (const bool rising : {true, false}) {
    const auto volume = make_volume(cube(5), [&](glm::dvec3 p) { return rising ? p.z / 4 : 1 - p.z / 4; });
    glm::dvec4 expected(0);
    for (int i = 0; i < 4; ++i)
      expected += glm::dvec4(colors[rising ? i : 3 - i], 1) * (0.5 * (1 - expected.a));
    Scene scene = scene_of(volume, make_tf(points), Mode::peak_only);
    scene.rendering.step = 4;
    const glm::vec4 pixel = render(scene, along_z(volume->grid, 4)).at(8, 8);
    for (int channel = 0; channel < 4; ++channel)
      EXPECT_NEAR(pixel[channel], expected[channel], 1e-6) << rising;
    scene.rendering.max_peaks = 1;  // of the paper's form alone
    EXPECT_EQ(render(scene, along_z(volume->grid, 4)).at(8, 8), pixel);
    scene.rendering.peak_form = PeakForm::paper;
    EXPECT_NEAR(render(scene, along_z(volume->grid, 4)).at(8, 8).a, 0.75,
                1e-6);  // one in each of the two intervals
  }
}

// Where samples fall exactly on the isovalue 2: crossings are counted once, touches never.
TEST_F(ClosedForm, SamplesOnTheIsovalue) {
  struct Case {
    std::array<double, 6> samples;  // at z = 0, 1, 3, 5, 7, 8: what a ray meets at step 2
    int crossings;
  };
  const Case cases[] = {
      {{0, 1, 3, 3, 1, 0}, 2}, {{0, 2, 3, 2, 0, 0}, 2},  // crossed at a sample
      {{4, 2, 0, 2, 4, 4}, 2}, {{0, 1, 2, 1, 0, 0}, 0},  // touched from below
      {{4, 3, 2, 3, 4, 4}, 0},                           // and from above
      {{0, 2, 2, 2, 1, 0}, 2},                           // a part on the value is inside
      {{0, 1, 2, 2, 3, 4}, 1}, {{4, 3, 2, 2, 3, 4}, 0},
      {{2, 1, 0, 0, 1, 2}, 0},  // touches the faces of the box
      {{2, 3, 4, 4, 3, 2}, 0},  // enters and leaves inside
      {{2, 2, 1, 1, 2, 2}, 2},
  };
  const auto tf = make_tf({point(0, 0), point(1.9, 0), point(2, 0.25), point(2.1, 0), point(4, 0)});
  for (const Case& test : cases) {
    const auto& s = test.samples;
    const double at_points[] = {
        s[0], s[1], (s[1] + s[2]) / 2, s[2], (s[2] + s[3]) / 2, s[3], (s[3] + s[4]) / 2, s[4], s[5]};
    const auto volume = make_volume(cube(9), [&](glm::dvec3 p) { return at_points[std::lround(p.z)]; });
    for (const double step : {2.0, 1.0, 0.5, 0.25, 0.3}) {
      Scene scene = scene_of(volume, tf, Mode::peak_only);
      scene.rendering.step = step;
      const double opacity = double(render(scene, along_z(volume->grid, 8), {17, 17}).at(8, 8).a);
      EXPECT_NEAR(opacity, 1 - std::pow(0.75, test.crossings), 1e-6)
          << ::testing::PrintToString(s) << ' ' << step;
    }
  }
}

// A sphere's surface is crossed twice by the rays that meet it and never by the others.
TEST_F(ClosedForm, SphereIsCrossedTwice) {
  const auto volume = make_volume(cube(33), [](glm::dvec3 p) { return 16 - glm::length(p - 16.0); });
  const auto tf = make_tf({point(0, 0), point(5.999, 0), point(6, 0.4), point(6.001, 0), point(16, 0)});
  const Image image = render(scene_of(volume, tf, Mode::peak_only), along_z(volume->grid, 32), {65, 65});
  for (int y = 0; y < 65; ++y)
    for (int x = 0; x < 65; ++x) {
      const double distance = std::hypot((x - 32.0) * 32 / 65, (y - 32.0) * 32 / 65);
      if (std::abs(distance - 10) < 0.3) continue;  // the silhouette of the sampled sphere
      EXPECT_NEAR(image.at(x, y).a, distance < 10 ? 0.64 : 0.0, 1e-5) << x << ' ' << y;
    }
}

// XOR in the split form: haze, a surface in it, haze; neither is counted twice and the step does not matter.
TEST_F(ClosedForm, ExclusiveSplitDoesNotDependOnTheStep) {
  const auto volume = make_volume(cube(17), [](glm::dvec3 p) { return p.z / 16; });
  const glm::dvec3 blue(0, 0, 1), red(1, 0, 0);
  const auto tf = make_tf({point(0, 0.2, blue), point(0.3699, 0.2, blue), point(0.37, 0.5, red),
                           point(0.3701, 0.2, blue), point(1, 0.2, blue)},
                          8.0);
  const double front = std::pow(0.8, 0.37 * 16 / 8), back = std::pow(0.8, 0.63 * 16 / 8);
  for (const double step : {16.0, 5.0, 1.0, 0.25, 0.01}) {
    Scene scene = scene_of(volume, tf, Mode::peak_xor_dvr);
    scene.rendering.step = step;
    const glm::vec4 pixel = render(scene, along_z(volume->grid, 16)).at(8, 8);
    EXPECT_NEAR(pixel.r, front * 0.5, 3e-6) << step;
    EXPECT_NEAR(pixel.b, (1 - front) + front * 0.5 * (1 - back), 3e-6) << step;
    EXPECT_NEAR(pixel.a, 1 - front * 0.5 * back, 3e-6) << step;
  }
}

// The paper's form leaves out the DVR sample of a step with a crossing, so that it depends on the step.
TEST_F(ClosedForm, ExclusivePaperLosesOneSample) {
  const auto volume = make_volume(cube(17), [](glm::dvec3 p) { return p.z / 16; });
  const auto tf =
      make_tf({point(0, 0.2), point(0.3699, 0.2), point(0.37, 0.5), point(0.3701, 0.2), point(1, 0.2)}, 8.0);
  for (const double step : {2.0, 1.0}) {
    Scene scene = scene_of(volume, tf, Mode::peak_xor_dvr, PeakForm::paper);
    scene.rendering.step = step;
    const double expected = 1 - 0.5 * std::pow(0.8, (16 - step) / 8);
    EXPECT_NEAR(render(scene, along_z(volume->grid, 16)).at(8, 8).a, expected, 3e-6) << step;
  }
}

// Rays that pass beside the box, and a box behind the eye, are empty.
TEST_F(ClosedForm, NothingBesideOrBehind) {
  const auto volume = make_volume(cube(9), [](glm::dvec3) { return 0.5; });
  const auto tf = make_tf({point(0, 0.5), point(1, 0.5)});
  for (const Mode mode : all_modes) {
    const Image wide = render(scene_of(volume, tf, mode), along_z(volume->grid, 16));
    EXPECT_EQ(wide.at(0, 0), glm::vec4(0));
    Camera behind = along_z(volume->grid, 16);
    behind.target = behind.eye + (behind.eye - behind.target);
    for (const auto& pixel : render(scene_of(volume, tf, mode), behind).pixels)
      EXPECT_EQ(pixel, glm::vec4(0));
  }
}

// A sphere's shell in parallel projection: a disc of two crossings a ray, as large wherever the eye is, and
// as much haze before and behind it as the box is long.
TEST_F(ClosedForm, ASphereInParallelProjectionIsADisc) {
  const Grid grid{glm::ivec3(65), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return glm::length(p - glm::dvec3(32)); });
  Scene scene{volume, make_tf({point(0, 0), point(20, 0), point(20, 0.5), point(20, 0), point(60, 0)}), {}};
  scene.rendering.mode = Mode::peak_only;
  const glm::ivec2 size(64);
  for (const double distance : {5.0, 40.0, 300.0})
    for (const auto method : {ClassificationMethod::post, ClassificationMethod::analytic}) {
      scene.rendering.classification = method;
      Camera camera{.eye = {32, 32, 32 - distance}, .target = glm::dvec3(32), .up = {0, 1, 0}, .unknown = {}};
      camera.projection = Projection::parallel;
      camera.fov_y_degrees = glm::degrees(2 * std::atan(32 / distance));  // a pixel is one voxel
      const Image image = render(scene, camera, size);
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const double radius = std::hypot(x + 0.5 - 32, y + 0.5 - 32);
          if (std::abs(radius - 20) < 0.2) continue;  // the sphere of the grid's points is one of flat pieces
          ASSERT_NEAR(image.at(x, y).a, radius < 20 ? 0.75 : 0, 1e-5)
              << "eye at " << distance << ": " << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace crest::testing
