#include <algorithm>
#include <cmath>
#include <optional>

#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/studies/placement/segments.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/brute_force.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

constexpr Placement all_placements[] = {Placement::eye, Placement::entry, Placement::entry_exit,
                                        Placement::entry_exit_corner};

/// A box of 8 voxels seen along z from `distance` before it, by a single ray.
constexpr double depth = 8, distance = 10.25;

Camera along_the_axis() {
  Camera camera;
  camera.eye = {4, 4, -distance};
  camera.target = {4, 4, 4};
  camera.fov_y_degrees = 0.01;
  return camera;
}

std::shared_ptr<const Volume> ramp() {
  return make_volume(Grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(0)},
                     [](glm::dvec3 p) { return p.z / depth; });
}

class Placements : public RaycasterTest {
 protected:
  glm::vec4 pixel(const Scene& scene) { return render(scene, along_the_axis(), {1, 1}).at(0, 0); }
};

// What each placement counts of a slab 8 long, in numbers that can be checked by hand: eye and entry count
// too much or too little, and entry_exit misses a slab thinner than a step.
TEST_F(Placements, LengthOfASlab) {
  struct Case {
    Placement placement;
    double step, counted;
  };
  const Case cases[] = {
      {Placement::entry_exit_corner, 3, 8},
      {Placement::entry_exit_corner, 20, 8},
      {Placement::entry_exit, 3, 8},
      {Placement::entry_exit, 20, 0},
      {Placement::entry, 3, 9},    // samples at 1.5, 4.5, 7.5
      {Placement::entry, 3.5, 7},  // at 1.75, 5.25; 8.75 is beyond the exit
      {Placement::entry, 5, 10},   // at 2.5, 7.5
      {Placement::entry, 20, 0},   // 10 is beyond
      {Placement::eye, 3, 9},      // at 12, 15, 18 from the eye, of 10.25 .. 18.25
      {Placement::eye, 7, 7},      // at 14
      {Placement::eye, 5, 5},      // at 15
      {Placement::eye, 9.2, 0},    // 9.2 is before the entry, 18.4 beyond the exit
  };
  Scene scene{ramp(), make_tf({point(0, 0.2), point(1, 0.2)}, 8), {}};
  for (const Case& test : cases)
    for (const Mode mode : {Mode::both, Mode::dvr_only}) {
      scene.rendering.mode = mode;
      scene.rendering.placement = test.placement;
      scene.rendering.step = test.step;
      EXPECT_NEAR(pixel(scene).a, 1 - std::pow(0.8, test.counted / 8), 1e-6)
          << name_of(test.placement) << ' ' << test.step;
    }
}

// A surface in haze: its crossing cuts a segment, and the haze counts as it does without it, before and
// behind; also where the surface lies before the first sample, behind the last, or in a part that no
// segment covers.
TEST_F(Placements, ACrossingCutsOneSegment) {
  const glm::dvec3 blue(0, 0, 1), red(1, 0, 0);
  const auto volume = ramp();
  for (const double place : {0.003, 0.013, 0.05, 0.3, 0.37, 0.5, 0.63, 0.77, 0.9, 0.94, 0.97, 0.995}) {
    Scene scene{volume,
                make_tf({point(0, 0.2, blue), point(place - 1e-5, 0.2, blue), point(place, 0.5, red),
                         point(place + 1e-5, 0.2, blue), point(1, 0.2, blue)},
                        8),
                {}};
    scene.rendering.mode = Mode::peak_xor_dvr;
    for (const Placement placement : all_placements)
      for (const double step : {20.0, 5.0, 3.5, 3.0, 1.0, 0.37}) {
        scene.rendering.placement = placement;
        scene.rendering.step = step;
        const Segments s = segments_of(placement, step, distance, distance + depth);
        const double hit = std::clamp(distance + place * depth, s.begin, s.end());
        const double front = std::pow(0.8, (hit - s.begin) / 8), back = std::pow(0.8, (s.end() - hit) / 8);
        const glm::vec4 color = pixel(scene);
        EXPECT_NEAR(color.r, front * 0.5, 3e-6) << name_of(placement) << ' ' << step << ' ' << place;
        EXPECT_NEAR(color.b, (1 - front) + front * 0.5 * (1 - back), 3e-6)
            << name_of(placement) << ' ' << step << ' ' << place;
        EXPECT_NEAR(color.a, 1 - front * 0.5 * back, 3e-6)
            << name_of(placement) << ' ' << step << ' ' << place;
      }
  }
}

// Surfaces are found between entry and exit wherever the samples are, also where there is none.
TEST_F(Placements, PeaksNeedNoSample) {
  const auto volume = ramp();
  for (const double place : {0.01, 0.4, 0.99})
    for (const Mode mode : {Mode::peak_only, Mode::both})
      for (const PeakForm form : {PeakForm::split, PeakForm::paper})
        for (const Placement placement : all_placements)
          for (const double step : {20.0, 1.0}) {
            Scene scene{volume,
                        make_tf({point(0, 0), point(place - 1e-5, 0), point(place, 0.6),
                                 point(place + 1e-5, 0), point(1, 0)},
                                8),
                        {}};
            scene.rendering.mode = mode;
            scene.rendering.peak_form = form;
            scene.rendering.placement = placement;
            scene.rendering.step = step;
            EXPECT_NEAR(pixel(scene).a, 0.6, 1e-6) << name_of(placement) << ' ' << step << ' ' << place;
          }
}

/// DVR of one ray by segments in double; nothing where the number of segments hangs on rounding.
std::optional<glm::dvec4> brute_dvr(const Scene& scene, const BruteRay& ray) {
  const double step = scene.rendering.step;
  const Placement placement = scene.rendering.placement;
  const Segments s = segments_of(placement, step, ray.enter, ray.exit);
  for (const double shift : {-1e-4, 1e-4}) {
    if (segments_of(placement, step, ray.enter + shift, ray.exit).n != s.n) return std::nullopt;
    const Segments moved = segments_of(placement, step, ray.enter, ray.exit + shift);
    if (moved.n != s.n || std::abs(moved.begin - s.begin) > 1e-3) return std::nullopt;
  }
  const double unit = scene.volume->grid.smallest_spacing();
  glm::dvec4 sum(0);
  for (int i = 0; i < s.n; ++i) {
    const double t = s.begin + (i + 0.5) * s.size;
    const double value = trilinear(*scene.volume, ray.origin + t * ray.direction);
    const Classified material = evaluate(scene.tf, value);
    const double alpha = -std::expm1(-extinction(material.opacity, scene.tf.unit_distance) * s.size * unit);
    sum += (1 - sum.a) * alpha * glm::dvec4(material.color, 1);
  }
  return sum;
}

// Rays of all directions and lengths, the corners' among them, against the listings' sums.
TEST_F(Placements, AgreeWithTheListings) {
  const auto volume = std::make_shared<const Volume>(make_builtin("sphere?n=12"));
  Scene scene{volume, make_tf({point(-1, 0.1, {1, 0, 0}), point(1, 0.6, {0, 1, 0.5})}, 4), {}};
  scene.rendering.mode = Mode::dvr_only;
  const Camera camera = whole_volume_camera(volume->grid, 1, 50);
  constexpr glm::ivec2 size{48, 48};
  for (const Placement placement : all_placements)
    for (const double step : {3.0, 0.7}) {
      scene.rendering.placement = placement;
      scene.rendering.step = step;
      const Image image = render(scene, camera, size);
      int compared = 0, empty = 0;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const BruteRay ray = brute_ray(camera, volume->grid, size, x, y);
          if (!ray.hits()) continue;
          const auto expected = brute_dvr(scene, ray);
          if (!expected) continue;
          ++compared;
          empty += expected->a == 0;
          EXPECT_LT(glm::length(glm::dvec4(image.at(x, y)) - *expected), 2e-5)
              << name_of(placement) << ' ' << step << " at " << x << ' ' << y;
        }
      EXPECT_GT(compared, 900) << name_of(placement);
      EXPECT_EQ(empty == 0, placement == Placement::entry_exit_corner) << name_of(placement);
    }
}

TEST_F(Placements, PassesJoinWithoutASeam) {
  const auto volume = std::make_shared<const Volume>(make_builtin("gyroid?n=24"));
  const Camera camera = whole_volume_camera(volume->grid, 1);
  for (const Placement placement : all_placements)
    for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::peak_only, Mode::dvr_only})
      for (const PeakForm form : {PeakForm::split, PeakForm::paper}) {
        Scene scene = make_scene(volume, load_preset("four-peaks"));
        scene.rendering.mode = mode;
        scene.rendering.peak_form = form;
        scene.rendering.placement = placement;
        const Image whole = render(scene, camera, {32, 32});
        raycaster.force({.features = {}, .intervals_per_pass = 5});
        const Image sliced = render(scene, camera, {32, 32});
        raycaster.force({});
        double largest = 0;
        for (std::size_t i = 0; i < whole.pixels.size(); ++i)
          largest = std::max(largest, double(glm::length(whole.pixels[i] - sliced.pixels[i])));
        EXPECT_LT(largest, 2e-5) << name_of(placement) << ' ' << name_of(mode) << ' ' << name_of(form);
      }
}

// Only the placement that is asked for is in the shader, and the default brings nothing.
TEST_F(Placements, AreNamedAmongTheFeatures) {
  Scene scene{ramp(), make_tf({point(0, 0.2), point(1, 0.2)}), {}};
  const auto names = [&] { return feature_names(raycaster.features(scene, false)); };
  EXPECT_EQ(names(), std::vector<std::string>{"dvr"});
  scene.rendering.placement = Placement::eye;
  EXPECT_EQ(names(), (std::vector<std::string>{"dvr", "placement_eye"}));
  scene.tf.points[0].opacity = scene.tf.points[1].opacity = 0;
  EXPECT_EQ(names(), std::vector<std::string>{}) << "nothing is sampled";
}

}  // namespace
}  // namespace crest::testing
