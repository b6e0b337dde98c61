#include <cmath>

#include "presets/error.h"
#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/reference/reference.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

constexpr ClassificationMethod both_forms[] = {ClassificationMethod::preintegrated,
                                               ClassificationMethod::preintegrated_table};

class Preintegration : public RaycasterTest {
 protected:
  static Grid cube(int n) { return Grid{glm::ivec3(n), glm::dvec3(1), glm::dvec3(0)}; }

  /// The field z/16 in a box 16 deep.
  static std::shared_ptr<const Volume> ramp(int n = 17) {
    return make_volume(cube(n), [n](glm::dvec3 p) { return p.z / (n - 1); });
  }

  static void set(Scene& scene, ClassificationMethod method) {
    scene.rendering.classification = method;
    scene.rendering.placement =
        method == ClassificationMethod::preintegrated_table ? Placement::entry : Placement::entry_exit_corner;
  }

  glm::vec4 pixel(const Scene& scene) {
    const Grid& grid = scene.volume->grid;
    return render(scene, along_z(grid, grid.box_size().x)).at(8, 8);
  }
};

Scene scene_of(std::shared_ptr<const Volume> volume, TransferFunction tf, Mode mode = Mode::dvr_only) {
  Scene scene{std::move(volume), std::move(tf), {}};
  scene.rendering.mode = mode;
  return scene;
}

double largest_difference(const Image& a, const Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 4; ++channel)
      largest = std::max(largest, double(std::abs(a.pixels[i][channel] - b.pixels[i][channel])));
  return largest;
}

// One material: from entry to exit with every step and placement, though steps do not fit in.
TEST_F(Preintegration, ConstantSlab) {
  const auto volume = make_volume(cube(9), [](glm::dvec3) { return 0.5; });
  const double opacity = 1 - std::pow(0.7, 8.0 / 4.0);
  Scene scene =
      scene_of(volume, make_tf({point(0, 0.3, {1, 0.5, 0.25}), point(1, 0.3, {1, 0.5, 0.25})}, 4.0));
  for (const ClassificationMethod method : both_forms)
    for (const Placement placement :
         {Placement::eye, Placement::entry, Placement::entry_exit, Placement::entry_exit_corner})
      for (const double step : {20.0, 8.0, 3.0, 0.37, 1.0 / 64}) {
        set(scene, method);
        if (method == ClassificationMethod::preintegrated) scene.rendering.placement = placement;
        scene.rendering.step = step;
        const glm::vec4 color = pixel(scene);
        EXPECT_NEAR(color.a, opacity, 2e-6) << name_of(method) << ' ' << name_of(placement) << ' ' << step;
        EXPECT_NEAR(color.g, 0.5 * opacity, 2e-6);
        EXPECT_NEAR(color.b, 0.25 * opacity, 2e-6);
      }
}

// On a linear field opacity is exact whatever the step, also where the TF is constant beyond its span, and
// where it has a step, or reaches opacity 1.
TEST_F(Preintegration, OpacityOfALinearFieldIsExact) {
  const TransferFunction tfs[] = {
      make_tf({point(0, 0), point(1, 0.9)}, 4.0),
      make_tf({point(0.2, 0.1), point(0.55, 0.6), point(0.7, 0.05)}, 8.0),
      make_tf({point(0, 0.1), point(0.4, 0.1), point(0.4, 0.6), point(1, 0.2)}, 8.0),
      make_tf({point(0, 0), point(0.5, 1), point(1, 0)}, 64.0)};
  for (const TransferFunction& tf : tfs) {
    Scene scene = scene_of(ramp(), tf);
    scene.rendering.classification = ClassificationMethod::preintegrated;
    const Camera camera = along_z(scene.volume->grid, 16);
    const double right = render_reference(scene, camera, {1, 1}, Answer::integral).pixels[0].a;
    for (const double step : {16.0, 5.0, 1.0, 0.3, 0.01}) {
      scene.rendering.step = step;
      EXPECT_NEAR(pixel(scene).a, right, 2e-6) << step;
    }
  }
}

// Sampling steps over a spike of a millionth of the range; pre-integration has all of its depth.
TEST_F(Preintegration, ASpikeKeepsItsDepth) {
  Scene scene =
      scene_of(ramp(), make_tf({point(0, 0), point(0.37, 0, {1, 0, 0}), point(0.37 + 5e-7, 1, {1, 0, 0}),
                                point(0.37 + 1e-6, 0, {1, 0, 0}), point(1, 0)},
                               1e-5));
  const Camera camera = along_z(scene.volume->grid, 16);
  const double right = render_reference(scene, camera, {1, 1}, Answer::integral).pixels[0].a;
  ASSERT_GT(right, 0.5);
  ASSERT_LT(right, 0.9);
  for (const double step : {16.0, 1.0, 0.13}) {
    scene.rendering.step = step;
    set(scene, ClassificationMethod::post);
    EXPECT_EQ(pixel(scene).a, 0) << step;
    set(scene, ClassificationMethod::preintegrated);
    EXPECT_NEAR(pixel(scene).a, right, 2e-5) << step;
    EXPECT_NEAR(pixel(scene).r, right, 2e-5) << step;
    if (step < 0.5) continue;
    set(scene, ClassificationMethod::preintegrated_table);  // its front edge is blurred by a bin
    EXPECT_NEAR(pixel(scene).a, right, 0.05) << step;
  }
}

// Surfaces in haze cut their segments, in every form; the haze counts before and behind as it does without
// them.
TEST_F(Preintegration, SurfacesInHaze) {
  const glm::dvec3 blue(0, 0, 1), red(1, 0, 0);
  for (const double place : {0.003, 0.05, 0.37, 0.5, 0.77, 0.995})
    for (const ClassificationMethod method : both_forms)
      for (const double step : {16.0, 5.0, 1.0, 0.37, 0.05}) {
        Scene scene =
            scene_of(ramp(),
                     make_tf({point(0, 0.2, blue), point(place - 1e-5, 0.2, blue), point(place, 0.5, red),
                              point(place + 1e-5, 0.2, blue), point(1, 0.2, blue)},
                             8),
                     Mode::peak_xor_dvr);
        set(scene, method);
        scene.rendering.step = step;
        const double front = std::pow(0.8, place * 16 / 8), back = std::pow(0.8, (1 - place) * 16 / 8);
        const glm::vec4 color = pixel(scene);
        EXPECT_NEAR(color.r, front * 0.5, 4e-6) << name_of(method) << ' ' << step << ' ' << place;
        EXPECT_NEAR(color.b, (1 - front) + front * 0.5 * (1 - back), 4e-6) << step << ' ' << place;
        EXPECT_NEAR(color.a, 1 - front * 0.5 * back, 4e-6) << step << ' ' << place;
      }
}

// Four surfaces in one segment, each with the material before it, rising or falling: none is lost.
TEST_F(Preintegration, SurfacesOfOneSegmentInTheirOrder) {
  const glm::dvec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  std::vector<ControlPoint> points{point(0, 0.2, {1, 1, 1})};
  for (int i = 0; i < 4; ++i) {
    const double v = 0.2 + 0.17 * i, a = 0.2 + 0.1 * i;
    points.insert(points.end(), {point(v - 1e-4, a), point(v, 0.7, colors[i]), point(v + 1e-4, a)});
  }
  points.push_back(point(1, 0.6));
  for (const bool rising : {true, false})
    for (const Mode mode : {Mode::peak_xor_dvr, Mode::both}) {
      const auto volume = make_volume(cube(5), [&](glm::dvec3 p) { return rising ? p.z / 4 : 1 - p.z / 4; });
      Scene scene = scene_of(volume, make_tf(points, 2.0), mode);
      scene.rendering.classification = ClassificationMethod::preintegrated;
      const Camera camera = along_z(volume->grid, 4);
      const glm::dvec4 right =
          render_reference(scene, camera, {1, 1}, answers_of(scene.rendering).front()).pixels[0];
      for (const double step : {8.0, 4.0, 1.0, 0.25}) {
        scene.rendering.step = step;
        const glm::vec4 color = pixel(scene);
        EXPECT_NEAR(color.a, right.a, 3e-6) << name_of(mode) << ' ' << step;
        for (int channel = 0; channel < 3; ++channel)
          EXPECT_NEAR(color[channel], right[channel], 2e-2 * step / 4) << name_of(mode) << ' ' << step;
      }
      scene.rendering.step = 8;
      EXPECT_EQ(count(scene, camera).crossings, 4 * 256);
      EXPECT_EQ(count(scene, camera).samples, (2 + 4 * 2) * 256);  // both ends, and two for each root
    }
}

// As published: a segment with a crossing counts whole behind its peaks, or not at all.
TEST_F(Preintegration, ThePapersForm) {
  const auto tf =
      make_tf({point(0, 0.2), point(0.3699, 0.2), point(0.37, 0.5), point(0.3701, 0.2), point(1, 0.2)}, 8);
  const double spike_depth = 16 * 2e-4 * 0.5 / 8;  // of the spike's body, no more
  for (const ClassificationMethod method : both_forms)
    for (const double step : {2.0, 1.0}) {
      Scene scene = scene_of(ramp(), tf, Mode::peak_xor_dvr);
      set(scene, method);
      scene.rendering.peak_form = PeakForm::paper;
      scene.rendering.step = step;
      EXPECT_NEAR(pixel(scene).a, 1 - 0.5 * std::pow(0.8, (16 - step) / 8), spike_depth) << step;
      scene.rendering.mode = Mode::both;
      EXPECT_NEAR(pixel(scene).a, 1 - 0.5 * std::pow(0.8, 16.0 / 8), spike_depth) << step;
    }
}

Scene library_scene(const std::string& builtin, const std::string& preset, Mode mode, PeakForm form) {
  Scene scene = make_scene(std::make_shared<const Volume>(make_builtin(builtin)), load_preset(preset));
  scene.rendering.mode = mode;
  scene.rendering.peak_form = form;
  return scene;
}

// Passes begin at any segment, and join; tables and tests that nobody needs change nothing.
TEST_F(Preintegration, PassesJoinWithoutASeam) {
  for (const ClassificationMethod method : both_forms)
    for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::dvr_only})
      for (const PeakForm form : {PeakForm::split, PeakForm::paper})
        for (const Shading shading : {Shading::none, Shading::gradient}) {
          if (shading == Shading::gradient && mode != Mode::peak_xor_dvr) continue;
          Scene scene = library_scene("gyroid?n=24", "four-peaks", mode, form);
          set(scene, method);
          scene.rendering.preintegration_bins = 64;
          scene.rendering.shading = shading;
          const Camera camera = whole_volume_camera(scene.volume->grid, 1);
          const Image whole = render(scene, camera, {48, 48});
          raycaster.force({.features = {}, .intervals_per_pass = 7});
          EXPECT_LT(largest_difference(whole, render(scene, camera, {48, 48})), 2e-5)
              << int(mode) << int(form);
          raycaster.force({.features = {.peak_table = true,
                                        .several_peaks = true,
                                        .early_termination = true,
                                        .empty_cells = true},
                           .large_tables = false});
          EXPECT_LT(largest_difference(whole, render(scene, camera, {48, 48})), 1e-6)
              << int(mode) << int(form);
          raycaster.force({});
        }
}

// Where nothing shows, nothing is sampled, and the picture is the same.
TEST_F(Preintegration, SkippingChangesNothing) {
  for (const ClassificationMethod method : both_forms)
    for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::dvr_only}) {
      Scene scene = library_scene("vessels?n=48", "vessels-shell", mode, PeakForm::split);
      scene.rendering.shading = Shading::none;
      set(scene, method);
      const Camera camera = whole_volume_camera(scene.volume->grid, 1);
      scene.rendering.skipping = false;
      const Image whole = render(scene, camera, {48, 48});
      const double samples = count(scene, camera, {48, 48}).samples;
      scene.rendering.skipping = true;
      EXPECT_LT(largest_difference(whole, render(scene, camera, {48, 48})), 2e-6)
          << name_of(method) << int(mode);
      EXPECT_LT(count(scene, camera, {48, 48}).samples, 0.7 * samples);
    }
}

// Antiderivatives hold for steps that grow and steps that are joined: on a linear field opacity is exact with
// all.
TEST_F(Preintegration, StepsMayVary) {
  Scene scene = scene_of(ramp(), make_tf({point(0.2, 0.1), point(0.55, 0.6), point(0.7, 0.05)}, 8.0));
  scene.rendering.classification = ClassificationMethod::preintegrated;
  Camera camera = along_z(scene.volume->grid, 16);
  camera.eye = camera.target - glm::dvec3(0, 0, 20);
  camera.fov_y_degrees = 5;  // of one pixel: a first step of half a voxel
  const double right = render_reference(scene, camera, {1, 1}, Answer::integral).pixels[0].a;
  for (const Sampling sampling : {Sampling::uniform, Sampling::differential, Sampling::footprint})
    for (const bool adaptive : {false, true})
      for (const Placement placement : {Placement::entry_exit_corner, Placement::entry, Placement::eye}) {
        scene.rendering.sampling = sampling;
        scene.rendering.adaptive = adaptive;
        scene.rendering.placement = placement;
        scene.rendering.step = 0.7;
        EXPECT_NEAR(render(scene, camera, {1, 1}).at(0, 0).a, right, 3e-6) << name_of(sampling) << adaptive;
      }
}

// Surfaces may lie in another filter's field: what is pre-integrated between them is of the samples' own.
TEST_F(Preintegration, SurfacesOfAnotherFilter) {
  const auto volume = make_volume(cube(9), [](glm::dvec3 p) {
    return p.z / 8 + 0.1 * std::sin(1.3 * p.x + 0.9 * p.z) * std::cos(1.1 * p.y);
  });
  Scene scene =
      scene_of(volume,
               make_tf({point(-0.2, 0.1, {0, 0, 1}), point(0.499, 0.3, {0, 1, 0}), point(0.5, 0.7, {1, 0, 0}),
                        point(0.501, 0.3, {0, 1, 0}), point(1.2, 0.2, {1, 1, 1})},
                       4),
               Mode::peak_xor_dvr);
  scene.rendering.root_filter = Filter::bspline;
  const Camera camera = along_z(volume->grid, 7);
  const Image right = render_reference(scene, camera, {16, 16}, Answer::base_and_crossings).image();
  for (const ClassificationMethod method : both_forms) {
    set(scene, method);
    scene.rendering.step = 0.1;
    EXPECT_LT(largest_difference(render(scene, camera), right), 2e-4) << name_of(method);
  }
}

// A segment takes one value more than there are segments, and long rays are complete.
TEST_F(Preintegration, CountsItsSamples) {
  Scene scene = scene_of(ramp(), make_tf({point(0, 0.01), point(1, 0.02)}, 64.0));
  scene.rendering.classification = ClassificationMethod::preintegrated;
  scene.rendering.step = 0.5;
  const Camera camera = along_z(scene.volume->grid, 2);
  EXPECT_EQ(count(scene, camera, {1, 1}).samples, 33);
  EXPECT_EQ(count(scene, camera, {1, 1}).dvr_samples, 32);
  const double right = double(render(scene, camera, {1, 1}).at(0, 0).a);
  scene.rendering.step = 1.0 / 8192;  // 131,072 steps
  EXPECT_EQ(count(scene, camera, {1, 1}).dvr_samples, 131072);
  EXPECT_NEAR(render(scene, camera, {1, 1}).at(0, 0).a, right, 1e-5);
}

// Nothing spans a cell without a value.
TEST_F(Preintegration, EmptyCellsAreEmpty) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Grid grid = cube(9);
  const auto volume = make_volume(grid, [&](glm::dvec3 p) { return p.z == 4 ? nan : p.z < 4 ? 0.25 : 0.75; });
  const auto tf =
      make_tf({point(0, 0.3), point(0.4, 0.3), point(0.5, 0.9), point(0.6, 0.3), point(1, 0.3)}, 4);
  for (const ClassificationMethod method : both_forms)
    for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::dvr_only})
      for (const double step : {20.0, 2.0, 0.3}) {
        Scene scene = scene_of(volume, tf, mode);
        set(scene, method);
        scene.rendering.step = step;
        for (const auto& color : render(scene, along_z(grid, 6)).pixels)
          EXPECT_NEAR(color.a, 1 - std::pow(0.7, 6.0 / 4.0), 3e-6) << step;
      }
}

// It holds one step length: another sampling is refused in one sentence; what it does not need is left out.
TEST_F(Preintegration, TheTableTakesStepsFromTheEntry) {
  Scene scene = scene_of(ramp(), make_tf({point(0, 0.1), point(1, 0.2)}));
  scene.rendering.classification = ClassificationMethod::preintegrated_table;
  try {
    pixel(scene);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("takes placement entry, not entry_exit_corner"),
              std::string::npos)
        << error.what();
  }
  scene.rendering.placement = Placement::entry;
  EXPECT_TRUE(raycaster.features(scene, false).preintegration_table);
  scene.rendering.classification = ClassificationMethod::preintegrated;
  EXPECT_FALSE(raycaster.features(scene, false).preintegration_table);
  EXPECT_TRUE(raycaster.features(scene, false).preintegrated);
  scene.rendering.mode = Mode::peak_only;
  EXPECT_FALSE(raycaster.features(scene, false).preintegrated);
}

TEST_F(Preintegration, ErrorOfTheTableFallsWithItsSize) {
  const auto volume = std::make_shared<const Volume>(make_builtin("gyroid?n=24"));
  Scene scene = scene_of(volume, make_tf({point(-1.5, 0, {0, 0, 1}), point(-0.5, 0.3, {1, 0, 0}),
                                          point(0.2, 0.02, {0, 1, 0}), point(1.5, 0.6, {1, 1, 0})},
                                         0.1));
  set(scene, ClassificationMethod::preintegrated_table);
  const Camera camera = whole_volume_camera(volume->grid, 1);
  scene.rendering.preintegration_bins = 2048;
  const Image fine = render(scene, camera, {32, 32});
  double before = 1;
  for (const int bins : {9, 33, 129}) {
    scene.rendering.preintegration_bins = bins;
    const double error = largest_difference(render(scene, camera, {32, 32}), fine);
    EXPECT_LT(error, before / 8) << bins;
    before = error;
  }
  EXPECT_LT(before, 1e-3);
}

}  // namespace
}  // namespace crest::testing
