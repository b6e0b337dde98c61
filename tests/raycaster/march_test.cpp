#include <cmath>
#include <limits>
#include <random>

#include "presets/preset_file.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/brute_force.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

using March = RaycasterTest;

Scene scene_of(const std::string& builtin, const std::string& preset, Mode mode,
               PeakForm form = PeakForm::split) {
  Scene scene = make_scene(std::make_shared<const Volume>(make_builtin(builtin)), load_preset(preset));
  scene.rendering.mode = mode;
  scene.rendering.peak_form = form;
  return scene;
}

/// Few enough intervals a pass that a picture takes several.
TEST_F(March, PassesJoinWithoutASeam) {
  for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::peak_only, Mode::dvr_only})
    for (const PeakForm form : {PeakForm::split, PeakForm::paper}) {
      const Scene scene = scene_of("gyroid?n=24", "four-peaks", mode, form);
      const Camera camera = whole_volume_camera(scene.volume->grid, 1);
      const Image whole = render(scene, camera, {48, 48});
      raycaster.force({.features = {}, .intervals_per_pass = 7});
      const Image sliced = render(scene, camera, {48, 48});
      raycaster.force({});
      EXPECT_LT(largest_difference(whole, sliced), 2e-5) << int(mode) << int(form);
    }
}

// A ray of more steps than a driver allows one loop (65,535 on llvmpipe) is complete all the same.
TEST_F(March, LongRaysAreComplete) {
  Grid grid{{3, 3, 65}, glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3) { return 0.5; });
  Scene scene{volume, make_tf({point(0, 0.9), point(1, 0.9)}, 64.0), {}};
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.step = 1.0 / 2048;  // 131,072 steps
  EXPECT_NEAR(render(scene, along_z(grid, 2), {1, 1}).at(0, 0).a, 0.9, 1e-5);
  const RenderCounts counts = count(scene, along_z(grid, 2), {1, 1});
  EXPECT_EQ(counts.dvr_samples, 131072);
}

// A cell with a NaN or Inf corner is empty: nothing is drawn in it, and no surface is invented beside it.
TEST_F(March, EmptyCellsAreEmpty) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  Grid grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(0)};
  const auto holed = [&](glm::dvec3 p) {
    if (p.z == 4) return p.x < 4 ? nan : inf;  // the two cells on either side of z = 4 are empty
    return 0.5;
  };
  Scene scene{make_volume(grid, holed), make_tf({point(0, 0.3), point(1, 0.3)}, 4.0), {}};
  EXPECT_EQ(scene.volume->statistics.nan_count + scene.volume->statistics.inf_count, 81u);
  for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::dvr_only})
    for (const double step : {2.0, 1.0, 0.3}) {
      scene.rendering.mode = mode;
      scene.rendering.step = step;
      for (const auto& pixel : render(scene, along_z(grid, 6)).pixels)
        EXPECT_NEAR(pixel.a, 1 - std::pow(0.7, 6.0 / 4.0), 3e-6) << step;  // 8 less the two cells
    }
  // Values 0 before the hole and 1 behind it: the surface at 0.5 would lie in the hole
  Scene step{make_volume(grid, [&](glm::dvec3 p) { return p.z == 4  ? nan
                                                          : p.z < 4 ? 0.0
                                                                    : 1.0; }),
             make_tf({point(0, 0), point(0.5, 0.9), point(1, 0)}),
             {}};
  step.rendering.mode = Mode::peak_only;
  for (const auto& pixel : render(step, along_z(grid, 6)).pixels) EXPECT_EQ(pixel, glm::vec4(0));
}

// Surfaces where brute force finds them, in number: on rays that cross transversally, at half a voxel.
TEST_F(March, CrossingsAgreeWithBruteForce) {
  const Scene scene = scene_of("gyroid?n=48", "true-spike", Mode::peak_only);
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  constexpr glm::ivec2 size{64, 64};
  const double isovalue = find_peaks(scene.tf).front().value, opacity = find_peaks(scene.tf).front().opacity;
  Scene unshaded = scene;
  unshaded.rendering.shading = Shading::none;
  const Image image = render(unshaded, camera, size);
  int wrong = 0, with_surface = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const int crossings =
          brute_crossings(*scene.volume, brute_ray(camera, scene.volume->grid, size, x, y), isovalue, 64);
      with_surface += crossings > 0;
      wrong += std::abs(double(image.at(x, y).a) - (1 - std::pow(1 - opacity, crossings))) > 1e-4;
    }
  EXPECT_GT(with_surface, 1000);
  EXPECT_LE(wrong, with_surface / 500);
}

// The peak table (many peaks) and the test of all peaks at once (few) find the same surfaces.
TEST_F(March, TableAndListAgree) {
  std::vector<ControlPoint> points{point(-2, 0)};
  for (const double v : {-0.5, -0.1, 0.3, 0.7})
    points.insert(points.end(), {point(v - 1e-3, 0), point(v, 0.3, {1, v * v, 0}), point(v + 1e-3, 0)});
  points.push_back(point(2, 0));
  const auto volume = std::make_shared<const Volume>(make_builtin("gyroid?n=32"));
  Scene few{volume, make_tf(points), {}};
  few.rendering.mode = Mode::peak_only;
  // A fifth surface of no opacity, out of the others' way, calls for the table
  points.insert(points.end() - 1, {point(1.2, 0), point(1.21, 0), point(1.22, 0)});
  points[points.size() - 3].surface.mode = SurfaceMode::on;
  Scene many = few;
  many.tf = make_tf(points);
  ASSERT_FALSE(raycaster.features(few, false).peak_table);
  ASSERT_TRUE(raycaster.features(many, false).peak_table);
  const Camera camera = whole_volume_camera(volume->grid, 1);
  for (const int bins : {1, 3, 128, 512}) {
    many.rendering.peak_bins = bins;
    for (const double step : {0.5, 4.0}) {
      few.rendering.step = many.rendering.step = step;
      EXPECT_LT(largest_difference(render(few, camera, {64, 64}), render(many, camera, {64, 64})), 1e-6)
          << bins;
    }
  }
}

// The split form is of second order, so that a picture of half-voxel steps is near one of steps ten times
// shorter, on rays of all directions (lanes of a SIMD group meet their crossings at different steps).
TEST_F(March, SplitFormHardlyDependsOnTheStep) {
  for (const Mode mode : {Mode::peak_xor_dvr, Mode::both}) {
    Scene scene = scene_of("sphere?n=32", "onion", mode);
    scene.tf = make_tf({point(-1, 0.4, {0, 0, 1}), point(0.298, 0.4, {0, 0, 1}), point(0.3, 0.6, {1, 0, 0}),
                        point(0.302, 0.4, {0, 1, 0}), point(1, 0.4, {0, 1, 0})});
    scene.rendering.step = 0.5;
    const Camera camera = whole_volume_camera(scene.volume->grid, 1);
    const Image coarse = render(scene, camera, {64, 64});
    scene.rendering.step = 0.05;
    const Image fine = render(scene, camera, {64, 64});
    double sum = 0;
    for (std::size_t i = 0; i < fine.pixels.size(); ++i)
      sum += glm::length(fine.pixels[i] - coarse.pixels[i]);
    EXPECT_LT(sum / double(fine.pixels.size()), 1e-3) << int(mode);
  }
}

// Early termination changes nothing but what is hidden, and saves samples.
TEST_F(March, EarlyTermination) {
  Scene scene = scene_of("sphere?n=32", "smooth-haze", Mode::both);
  scene.tf.unit_distance *= 0.01;
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  const Image whole = render(scene, camera, {48, 48});
  const double all_samples = count(scene, camera, {48, 48}).samples;
  scene.rendering.early_termination = 0.004;
  EXPECT_LT(largest_difference(whole, render(scene, camera, {48, 48})), 0.004);
  const RenderCounts counts = count(scene, camera, {48, 48});
  EXPECT_LT(counts.samples, 0.9 * all_samples);
  EXPECT_LE(counts.dvr_samples, counts.samples);
}

// The counters against what the design says a ray costs.
TEST_F(March, SamplesAreCounted) {
  Grid grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return p.z / 8; });
  Scene scene{volume,
              make_tf({point(0, 0.1), point(0.52, 0.1), point(0.53, 0.5), point(0.54, 0.1), point(1, 0.1)}),
              {}};
  scene.rendering.step = 0.5;
  scene.rendering.mode = Mode::dvr_only;
  RenderCounts counts = count(scene, along_z(grid, 4), {4, 4});
  EXPECT_EQ(counts.hit_pixels, 16);
  EXPECT_EQ(counts.samples, 16 * 16);
  EXPECT_EQ(counts.dvr_samples, 16 * 16);
  for (const Mode mode : {Mode::both, Mode::peak_xor_dvr}) {
    scene.rendering.mode = mode;
    counts = count(scene, along_z(grid, 4), {4, 4});
    EXPECT_EQ(counts.samples, 16 * (16 + 2 + 2));  // the entry, the exit, and two for the root
    EXPECT_EQ(counts.dvr_samples, 16 * 16);
    EXPECT_EQ(counts.crossings, 16);
  }
}

// Nor does it matter how many surfaces one step meets.
TEST_F(March, NoCrossingOfHundredsInOneStepIsLost) {
  Grid grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return p.z / 8; });
  std::vector<ControlPoint> points{point(0, 0)};
  constexpr int surfaces = 400;
  for (int i = 0; i < surfaces; ++i) {
    const double v = (i + 0.5) / surfaces;
    points.insert(points.end(), {point(v - 1e-4, 0), point(v, 0.005), point(v + 1e-4, 0)});
  }
  points.push_back(point(1, 0));
  Scene scene{volume, make_tf(points), {}};
  scene.rendering.step = 8;
  for (const Mode mode : {Mode::peak_only, Mode::peak_xor_dvr}) {
    scene.rendering.mode = mode;
    EXPECT_EQ(count(scene, along_z(grid, 4), {2, 2}).crossings, 4 * surfaces);
    EXPECT_NEAR(render(scene, along_z(grid, 4), {2, 2}).at(0, 0).a, 1 - std::pow(0.995, surfaces), 2e-6);
  }
}

// A step composites all its crossings; in the paper's form those beyond max_peaks are left out, and counted.
TEST_F(March, CrossingsLeftOutAreCounted) {
  Grid grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return p.z / 8; });
  std::vector<ControlPoint> points{point(0, 0)};
  for (int i = 1; i <= 6; ++i)
    points.insert(points.end(), {point(0.1 * i - 1e-3, 0), point(0.1 * i, 0.2), point(0.1 * i + 1e-3, 0)});
  points.push_back(point(1, 0));
  Scene scene{volume, make_tf(points), {}};
  scene.rendering.mode = Mode::peak_only;
  scene.rendering.step = 8;  // one sample, in the middle: four of the six lie before it
  scene.rendering.max_peaks = 3;
  EXPECT_EQ(count(scene, along_z(grid, 4), {4, 4}).crossings, 16 * 6);
  scene.rendering.peak_form = PeakForm::paper;
  const RenderCounts counts = count(scene, along_z(grid, 4), {4, 4});
  EXPECT_EQ(counts.crossings + counts.crossings_left_out, 16 * 6);
  EXPECT_EQ(counts.crossings_left_out, 16);
  EXPECT_EQ(counts.hit_pixels, 16);
}

// What the studio compiles depends on the scene alone, and leaves out what it does not need.
TEST_F(March, FeaturesAreWhatTheSceneNeeds) {
  Scene scene = scene_of("sphere?n=16", "dirac-shell", Mode::peak_xor_dvr);
  EXPECT_TRUE(raycaster.features(scene, false).peaks);
  EXPECT_TRUE(raycaster.features(scene, false).base_tf);
  EXPECT_FALSE(raycaster.features(scene, false).peak_table);
  EXPECT_FALSE(raycaster.features(scene, false).statistics);
  scene.rendering.mode = Mode::dvr_only;
  EXPECT_FALSE(raycaster.features(scene, false).peaks);
  scene = scene_of("sphere?n=16", "smooth-haze", Mode::peak_xor_dvr);
  for (auto& p : scene.tf.points) p.surface.mode = SurfaceMode::off;
  EXPECT_FALSE(raycaster.features(scene, false).peaks);
  scene.tf = remap_values(scene.tf, {0, 1}, {100, 101});  // beside the data
  EXPECT_FALSE(raycaster.features(scene, false).peaks);
}

// World units do not matter: the whole scene scaled by powers of ten gives the same picture.
TEST_F(March, WorldUnitsDoNotMatter) {
  const Scene scene = scene_of("plume?n=32", "dirac-shell", Mode::both);
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  const Image image = render(scene, camera, {32, 32});
  for (const double scale : {1e-15, 1e-9, 1e6, 1e15}) {
    Volume volume = *scene.volume;
    volume.grid.spacing *= scale;
    volume.grid.origin *= scale;
    Scene scaled = scene;
    scaled.volume = std::make_shared<const Volume>(volume);
    scaled.tf.unit_distance *= scale;
    const Image other = render(scaled, whole_volume_camera(volume.grid, 1), {32, 32});
    EXPECT_LT(largest_difference(image, other), 1e-5) << scale;
  }
}

// Shading's gradient: on a linear field central differences are exact, so the light on a plane is known.
TEST_F(March, HeadlightOnAPlane) {
  Grid grid{glm::ivec3(17), glm::dvec3(1, 0.5, 2), glm::dvec3(0)};
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, -3));
  const auto volume = make_volume(
      grid, [&](glm::dvec3 p) { return glm::dot(p - grid.origin - 0.5 * grid.box_size(), normal); });
  Scene scene{
      volume, make_tf({point(-100, 0), point(-1e-4, 0), point(0, 0.8), point(1e-4, 0), point(100, 0)}), {}};
  scene.rendering.mode = Mode::peak_only;
  scene.rendering.shading = Shading::gradient;
  const glm::vec4 pixel = render(scene, along_z(grid, 2), {3, 3}).at(1, 1);
  EXPECT_NEAR(pixel.a, 0.8, 1e-6);
  EXPECT_NEAR(pixel.r, 0.8 * (0.25 + 0.75 * std::abs(normal.z)), 1e-4);
}

}  // namespace
}  // namespace crest::testing
