#include <cmath>
#include <limits>

#include "render/classify/stored_units.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

constexpr double float_max = double(std::numeric_limits<float>::max());

// A field goes to the GPU without losing a digit, and all that is compared with it moves the same way.
TEST(StoredUnits, LoseNoDigit) {
  const ValueRange ranges[] = {{0, 1},          {1e6, 1e6 + 1}, {-1e6 - 1, -1e6},        {1000, 2000},
                               {-3e-30, 4e-30}, {-1e30, 3e30},  {-float_max, float_max}, {0, 1e-42},
                               {7, 7}};
  for (const ValueRange range : ranges) {
    const StoredUnits units = stored_units(range);
    for (int i = 0; i <= 1000; ++i) {
      const float value = float(std::lerp(range.min, range.max, i / 1000.0));
      const float stored = units.stored(value);
      EXPECT_EQ(double(stored) / units.scale + units.base, double(value)) << range.min << ' ' << i;
      EXPECT_EQ(double(stored), units.stored(double(value)));
    }
  }
  EXPECT_TRUE(stored_units({0, 255}).is_identity());
  EXPECT_TRUE(stored_units({-1024, 3071}).is_identity());
  EXPECT_EQ(stored_units({1e6, 1e6 + 1}).base, 1e6);
  EXPECT_EQ(stored_units({-7, -6}).base, -6);
}

TEST(StoredUnits, AreOrdinaryWhateverTheRange) {
  for (const double scale : {1e-42, 1e-30, 1e30, float_max}) {
    const ValueRange stored = stored_units({-scale, scale}).stored(ValueRange{-scale, scale});
    EXPECT_GE(stored.width(), 0.5);
    EXPECT_LE(stored.width(), 1.0);
  }
}

using Precision = RaycasterTest;

// A surface between the last sample and the exit: what lies behind it is not lost.
TEST_F(Precision, HazeBehindASurfaceInTheLastHalfStep) {
  const Grid grid{glm::ivec3(17), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return p.z; });
  const glm::dvec3 blue(0, 0, 1), red(1, 0, 0);
  const double v = 15.9, front = std::pow(0.8, v / 8), back = std::pow(0.8, (16 - v) / 8);
  for (const Mode mode : {Mode::peak_xor_dvr, Mode::both})
    for (const double step : {0.5, 8.0, 16.0}) {
      Scene scene{volume,
                  make_tf({point(0, 0.2, blue), point(v, 0.2, blue), point(v, 0.5, red), point(v, 0.2, blue),
                           point(16, 0.2, blue)},
                          8.0),
                  {}};
      scene.rendering.mode = mode;
      scene.rendering.step = step;
      const glm::vec4 pixel = render(scene, along_z(grid, 8)).at(8, 8);
      EXPECT_NEAR(pixel.r, front * 0.5, 3e-6) << step;
      EXPECT_NEAR(pixel.b, (1 - front) + front * 0.5 * (1 - back), 3e-6) << step;
    }
}

// An extinction beyond float's range is opaque, and no NaN where a piece has no length.
TEST_F(Precision, ExtinctionBeyondFloat) {
  const Grid grid{glm::ivec3(5), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return p.z; });
  for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr, Mode::both}) {
    Scene scene{
        volume, make_tf({point(0, 0), point(1, 0), point(2, 0.5), point(3, 0.1), point(4, 0.9)}, 1e-300), {}};
    scene.rendering.mode = mode;
    EXPECT_EQ(render(scene, along_z(grid, 3)).at(8, 8).a, 1.f);
  }
}

// The surfaces of values near 1e-30 are those of the same values near 1: no product of them vanishes.
TEST_F(Precision, SurfacesWithinOneStepOfTinyValues) {
  const Grid grid{glm::ivec3(33), glm::dvec3(1), glm::dvec3(0)};
  RenderCounts counts[2];
  for (const int exponent : {0, -100}) {
    const double unit = std::ldexp(1.0, exponent);
    const auto volume = make_volume(grid, [&](glm::dvec3 p) { return unit * (16 - glm::length(p - 16.0)); });
    Scene scene{volume,
                make_tf({point(0, 0), point(5.9 * unit, 0), point(6 * unit, 0.4), point(6.1 * unit, 0),
                         point(16 * unit, 0)}),
                {}};
    scene.rendering.mode = Mode::peak_only;
    scene.rendering.step = 2;
    counts[exponent != 0] = count(scene, along_z(grid, 32), {64, 64});
  }
  EXPECT_GT(counts[0].crossings, 1000);
  EXPECT_EQ(counts[0].crossings, counts[1].crossings);
  EXPECT_EQ(counts[0].samples, counts[1].samples);
}

// From a corner of the box, rays that run along its faces end where they should.
TEST_F(Precision, RaysFromACorner) {
  const Grid grid{glm::ivec3(17), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3) { return 0.5; });
  Scene scene{volume, make_tf({point(0, 0.2), point(1, 0.2)}, 8.0), {}};
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.target = {8, 8, 0};  // in the face z = 0
  camera.up = {0, 0, 1};
  camera.fov_y_degrees = 2;
  const Image image = render(scene, camera, {9, 9});
  const double length = 16 * std::sqrt(2.0);
  EXPECT_NEAR(image.at(4, 4).a, 1 - std::pow(0.8, length / 8), 1e-6);
  EXPECT_EQ(image.at(4, 5).a, 0.f);  // just below
}

}  // namespace
}  // namespace crest::testing
