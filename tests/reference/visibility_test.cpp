#include "render/reference/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "presets/names.h"
#include "tests/reference/rays.h"

namespace crest::testing {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// x, from 0 to 8 along x.
std::shared_ptr<const Volume> ramp_along_x() {
  return volume_of({9, 3, 3}, [](int i, int, int) { return i; });
}

Scene scene_in(Mode mode, std::shared_ptr<const Volume> volume, TransferFunction tf) {
  Scene scene = scene_of(std::move(volume), std::move(tf));
  scene.rendering.mode = mode;
  return scene;
}

// Between 2 and 6 the extinction is a constant r: a bin from v to v + w, seen from the low end, makes
// exp(-r (v - 2)) (1 - exp(-r w)).
TEST(Visibility, OfABoxIsItsClosedForm) {
  const Scene scene = scene_in(Mode::dvr_only, ramp_along_x(), tf_of({{2, 0}, {2, 0.3}, {6, 0.3}, {6, 0}}));
  const double extinction = -std::log1p(-0.3), width = 0.5;
  for (const bool from_below : {true, false}) {
    const Camera camera = one_ray({from_below ? -5 : 13, 0.7, 1.3}, {4, 0.7, 1.3});
    const Visibility found = *measure_visibility(scene, camera, {1, 1}, 16);
    EXPECT_EQ(found.range, (ValueRange{0, 8}));
    for (std::size_t i = 0; i < 16; ++i) {
      const double value = 0.5 * double(i), in_front = from_below ? value - 2 : 6 - (value + width);
      const double expected =
          value < 2 || value >= 6 ? 0 : std::exp(-extinction * in_front) * -std::expm1(-extinction * width);
      EXPECT_NEAR(found.volume[i], expected, 1e-12) << value;
      EXPECT_EQ(found.surface[i], 0);
    }
  }
}

TEST(Visibility, OfSurfacesIsTheirOpacityBehindThoseInFront) {
  const Scene scene =
      scene_in(Mode::peak_only, ramp_along_x(),
               tf_of({{0, 0}, {2.95, 0}, {3, 0.5}, {3.05, 0}, {5.25, 0}, {5.3, 0.25}, {5.35, 0}, {8, 0}}));
  const Visibility found = *measure_visibility(scene, one_ray({-5, 0.7, 1.3}, {4, 0.7, 1.3}), {1, 1}, 8);
  EXPECT_EQ(sum(found.volume), 0);
  EXPECT_NEAR(found.surface[3], 0.5, 1e-12);  // at the lower end of its bin
  EXPECT_NEAR(found.surface[5], 0.5 * 0.25, 1e-12);
  EXPECT_NEAR(sum(found.surface), 0.625, 1e-12);
}

TransferFunction tent_and_spike() {
  return tf_of(
      {{-4, 0.02}, {-1.5, 0.3}, {-0.5, 0}, {0.78, 0.1}, {0.8, 0.6}, {0.82, 0.1}, {2, 0.05}, {4, 0.5}});
}

std::shared_ptr<const Volume> noise() { return std::make_shared<const Volume>(make_builtin("noise?n=12")); }

// What is red in a bin's values and black elsewhere is a picture of the bin alone.
TEST(Visibility, OfABinIsThePictureOfItAlone) {
  const Scene scene = scene_in(Mode::dvr_only, noise(), tent_and_spike());
  const Camera camera = whole_volume_camera(scene.volume->grid, 1, 40);
  constexpr glm::ivec2 size{9, 7};
  constexpr int bins = 12;
  const Visibility found = *measure_visibility(scene, camera, size, bins);
  for (const int bin : {2, 4, 6, 7, 9}) {
    const double low = found.range.min + found.range.width() * bin / bins,
                 high = found.range.min + found.range.width() * (bin + 1) / bins;
    Scene alone = scene;
    alone.tf.points.clear();
    const auto add = [&](double value, double opacity, glm::dvec3 color) {
      alone.tf.points.push_back({value, color, opacity, {}, {}});
    };
    const auto end = [&](double value, glm::dvec3 below, glm::dvec3 above) {
      add(value, evaluate(scene.tf, value).opacity, below);
      add(value, evaluate(scene.tf, value).opacity, above);
    };
    const auto copy = [&](double from, double to, glm::dvec3 color) {
      for (const ControlPoint& point : scene.tf.points)
        if (point.value > from && point.value < to) add(point.value, point.opacity, color);
    };
    constexpr glm::dvec3 black(0), red(1, 0, 0);
    copy(-1e9, low, black);
    end(low, black, red);
    copy(low, high, red);
    end(high, red, black);
    copy(high, 1e9, black);
    double expected = 0;
    for (const glm::dvec4& pixel : render_reference(alone, camera, size, Answer::integral).pixels)
      expected += pixel.r / (size.x * size.y);
    EXPECT_GT(expected, 1e-5);
    EXPECT_NEAR(found.volume[std::size_t(bin)], expected, 1e-7) << bin;
  }
}

TEST(Visibility, OfAllBinsIsThePicturesOpacity) {
  constexpr glm::ivec2 size{8, 6};
  for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::peak_only, Mode::dvr_only})
    for (const auto& [filter, root] : {std::pair(Filter::linear, Filter::linear),
                                       {Filter::bspline, Filter::bspline},
                                       {Filter::linear, Filter::bc}}) {
      Scene scene = scene_in(mode, noise(), tent_and_spike());
      scene.rendering.filter = filter;
      if (root != filter) scene.rendering.root_filter = root;
      const Camera camera = whole_volume_camera(scene.volume->grid, 1, 40);
      const Visibility found = *measure_visibility(scene, camera, size);
      double expected = 0;
      for (const glm::dvec4& pixel :
           render_reference(scene, camera, size, answers_of(scene.rendering).front()).pixels)
        expected += pixel.a / (size.x * size.y);
      EXPECT_NEAR(sum(found.volume) + sum(found.surface), expected, 1e-7) << name_of(mode);
      EXPECT_EQ(sum(found.surface) > 0, mode != Mode::dvr_only);
      EXPECT_EQ(sum(found.volume) > 0, mode != Mode::peak_only);
    }
}

TEST(Visibility, OfAVolumeOfOneValueAndOfAPictureThatWasStopped) {
  const Scene scene = scene_in(Mode::dvr_only, volume_of({3, 3, 3}, [](int, int, int) { return 2; }),
                               tf_of({{0, 0.5}, {4, 0.5}}));
  const Camera camera = one_ray({-3, 0.7, 1.3}, {1, 0.7, 1.3});
  EXPECT_NEAR(sum(measure_visibility(scene, camera, {1, 1}, 4)->volume), 0.75, 1e-12);
  std::stop_source source;
  source.request_stop();
  EXPECT_FALSE(measure_visibility(scene, camera, {1, 1}, 4, source.get_token()));
}

}  // namespace
}  // namespace crest::testing
