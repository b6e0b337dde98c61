#include <algorithm>
#include <cmath>
#include <limits>

#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

/// The volume's points from `first` to `last` as a volume of its own, with the whole one's statistics.
std::shared_ptr<const Volume> cropped(const Volume& whole, glm::ivec3 first, glm::ivec3 last) {
  Volume part;
  part.grid = {last - first + 1, whole.grid.spacing,
               whole.grid.origin + whole.grid.spacing * glm::dvec3(first)};
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i) part.values.floats().push_back(whole.at(i, j, k));
  part.statistics = whole.statistics;
  return std::make_shared<const Volume>(std::move(part));
}

ClipBox box_of(glm::dvec3 min, glm::dvec3 max) { return {min, max, ""}; }

using ClipBoxes = RaycasterTest;

// A clip box along the grid's planes is the volume cropped to them, in each mode, form and placement, with
// and without empty cells.
TEST_F(ClipBoxes, IsACrop) {
  const glm::ivec3 first(3, 0, 7), last(20, 14, 21);
  Volume holed = make_builtin("gyroid?n=24");
  holed.grid.spacing = {1, 1.25, 0.75};
  holed.grid.origin = {-4, 100, 0.5};
  const auto full = std::make_shared<const Volume>(holed);
  for (const glm::ivec3 hole : {glm::ivec3(8, 6, 10), {3, 9, 14}, {12, 14, 21}})
    holed.values.floats()[std::size_t(hole.x + 24 * (hole.y + 24 * hole.z))] =
        std::numeric_limits<float>::quiet_NaN();
  holed.statistics = compute_statistics(holed.grid, holed.values);
  for (const auto& whole : {full, std::make_shared<const Volume>(holed)}) {
    const auto part = cropped(*whole, first, last);
    const Camera camera = whole_volume_camera(whole->grid, 1);
    for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::peak_only, Mode::dvr_only})
      for (const PeakForm form : {PeakForm::split, PeakForm::paper})
        for (const Placement placement : {Placement::entry_exit_corner, Placement::eye, Placement::entry}) {
          Scene clipped = make_scene(whole, load_preset("four-peaks"));
          clipped.rendering.shading = Shading::none;
          clipped.rendering.mode = mode;
          clipped.rendering.peak_form = form;
          clipped.rendering.placement = placement;
          Scene crop = clipped;
          crop.volume = part;
          clipped.rendering.clip_box = box_of(part->grid.box_min(), part->grid.box_max());
          const Image a = render(clipped, camera, {40, 40}), b = render(crop, camera, {40, 40});
          // Rounding may turn a surface's touch, or a step more or less, on very few rays
          int off = 0, lit = 0;
          for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            off += glm::length(a.pixels[i] - b.pixels[i]) > 2e-4f;
            lit += b.pixels[i].a > 0;
          }
          EXPECT_GT(lit, 150);
          EXPECT_LE(off, 2) << name_of(mode) << ' ' << name_of(form) << ' ' << name_of(placement);
        }
  }
}

// Planes between the grid's points cut exactly there: haze and a surface in it, whose entry is no crossing.
TEST_F(ClipBoxes, CutsBetweenPoints) {
  const Grid grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(10)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return p.z - 10; });
  Scene scene{volume,
              make_tf({point(0, 0.2), point(3.999, 0.2), point(4, 0.5), point(4.001, 0.2), point(8, 0.2)}, 8),
              {}};
  scene.rendering.mode = Mode::peak_xor_dvr;
  struct Case {
    double min, max;
    bool has_surface;
  };
  for (const Case& test :
       {Case{2.3, 6.1, true}, {4.2, 7, false}, {0.5, 3.9, false}, {-5, 5, true}, {3, 99, true}})
    for (const double step : {0.3, 1.0, 20.0}) {
      scene.rendering.step = step;
      scene.rendering.clip_box = box_of({10, 10, 10 + test.min}, {18, 18, 10 + test.max});
      const double length = std::min(test.max, 8.0) - std::max(test.min, 0.0);
      const double clear = std::pow(0.8, length / 8) * (test.has_surface ? 0.5 : 1.0);
      for (const auto& pixel : render(scene, along_z(grid, 6), {4, 4}).pixels)
        EXPECT_NEAR(pixel.a, 1 - clear, 4e-6) << test.min << ' ' << test.max << ' ' << step;
    }
}

// Nothing where the boxes do not meet, or in a face that they share; all where the volume lies within.
TEST_F(ClipBoxes, BesideAndAround) {
  const auto volume = std::make_shared<const Volume>(make_builtin("sphere?n=16"));
  Scene scene = make_scene(volume, load_preset("smooth-haze"));
  scene.rendering.mode = Mode::both;
  const Camera camera = whole_volume_camera(volume->grid, 1);
  const glm::dvec3 low = volume->grid.box_min(), high = volume->grid.box_max(), size = high - low;
  const Image whole = render(scene, camera);
  for (const Mode mode : {Mode::both, Mode::dvr_only, Mode::peak_only}) {
    scene.rendering.mode = mode;
    for (const ClipBox& beside :
         {box_of(high + size, high + 2.0 * size), box_of(low - size, {low.x - 0.1 * size.x, high.y, high.z}),
          box_of({low.x, low.y, high.z}, high + size)}) {
      scene.rendering.clip_box = beside;
      for (const auto& pixel : render(scene, camera).pixels) EXPECT_EQ(pixel, glm::vec4(0));
    }
    scene.rendering.clip_box = box_of(low - size, low - 0.5 * size);
    EXPECT_EQ(count(scene, camera).hit_pixels, 0);
  }
  scene.rendering.mode = Mode::both;
  scene.rendering.clip_box = box_of(low - size, high + size);
  EXPECT_EQ(render(scene, camera).pixels, whole.pixels);
  const auto names = [&] { return feature_names(raycaster.features(scene, false)); };
  EXPECT_FALSE(std::ranges::count(names(), "clip_box"));
  scene.rendering.clip_box = box_of(low, high - 0.1 * size);
  EXPECT_TRUE(std::ranges::count(names(), "clip_box"));
  EXPECT_GT(largest_difference(render(scene, camera), whole), 0.01);
}

// The eye may be within, and nothing behind it is seen.
TEST_F(ClipBoxes, EyeInside) {
  const Grid grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(0)};
  Scene scene{
      make_volume(grid, [](glm::dvec3) { return 0.5; }), make_tf({point(0, 0.2), point(1, 0.2)}, 8), {}};
  scene.rendering.clip_box = box_of({1, 1, 1}, {7, 7, 7});
  Camera camera;
  camera.eye = {4, 4, 3};
  camera.target = {4, 4, 8};
  camera.fov_y_degrees = 0.01;
  EXPECT_NEAR(render(scene, camera, {1, 1}).at(0, 0).a, 1 - std::pow(0.8, 4.0 / 8), 1e-6);
}

// Shading at a cut takes the field on both sides of it: the gradient is the volume's, not the box's.
TEST_F(ClipBoxes, GradientsLookBeyondTheCut) {
  const Grid grid{glm::ivec3(17), glm::dvec3(1), glm::dvec3(0)};
  const auto volume =
      make_volume(grid, [](glm::dvec3 p) { return p.x * p.x - 20 * (p.z - 8) - 64; });  // 0 at x = 8, z = 8
  Scene scene{
      volume, make_tf({point(-400, 0), point(-1e-3, 0), point(0, 0.8), point(1e-3, 0), point(400, 0)}), {}};
  scene.rendering.mode = Mode::peak_only;
  scene.rendering.shading = Shading::gradient;
  scene.rendering.clip_box = box_of({8, 0, 0}, {16, 16, 16});
  Camera camera = along_z(grid, 1e-3);
  camera.eye.x += 1e-4;  // just within
  camera.target.x += 1e-4;
  const glm::dvec3 normal =
      glm::normalize(glm::dvec3(16, 0, -20));  // central differences of x^2 at 8 give 16
  EXPECT_NEAR(render(scene, camera, {1, 1}).at(0, 0).r, 0.8 * (0.25 + 0.75 * std::abs(normal.z)), 1e-3);
}

}  // namespace
}  // namespace crest::testing
