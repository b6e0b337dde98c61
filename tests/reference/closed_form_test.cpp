#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>

#include "tests/reference/rays.h"

// What the integral is where it can be written down: on fields that are trilinear, and that float32 holds
// exactly.
namespace crest::testing {
namespace {

constexpr double exact = 1e-10;
constexpr glm::dvec3 red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1}, white{1, 1, 1};
const double capped_depth = 24 * std::numbers::ln2;  // of one unit distance

/// The integral of -ln(1-a) da from 0 to a, the cap included.
double integral_of_depth(double a) {
  const double cap = 1 - 0x1p-24;
  if (a > cap) return integral_of_depth(cap) + capped_depth * (a - cap);
  return a + (1 - a) * std::log1p(-a);
}

/// The mean of -ln(1-a) on a line of opacities.
double mean_depth(double a, double b) {
  if (a == b) return -std::log1p(-std::min(a, 1 - 0x1p-24));
  return (integral_of_depth(b) - integral_of_depth(a)) / (b - a);
}

/// x, from 0 to 8 along x.
std::shared_ptr<const Volume> ramp_along_x() {
  return volume_of({9, 3, 3}, [](int i, int, int) { return i; });
}
OneRay through_x(const Scene& scene, Answer answer) {
  return along(scene, {-5, 0.7, 1.3}, {4, 0.7, 1.3}, answer);
}
/// Along the diagonal of x and y: f = x + y + z changes by sqrt(2) a length of 1.
std::shared_ptr<const Volume> sum_of_coordinates() {
  return volume_of({9, 9, 3}, [](int i, int j, int k) { return i + j + k; });
}

void expect_light(glm::dvec4 found, glm::dvec3 color, double alpha, double tolerance = exact) {
  EXPECT_NEAR(found.r, color.r, tolerance);
  EXPECT_NEAR(found.g, color.g, tolerance);
  EXPECT_NEAR(found.b, color.b, tolerance);
  EXPECT_NEAR(found.a, alpha, tolerance);
}

TEST(ReferenceClosedForm, ConstantMedium) {
  for (const double opacity : {1e-12, 0.01, 0.5, 0.999, 1.0})
    for (const double unit : {1e-9, 0.25, 3.0, 1e9}) {
      TransferFunction tf = colored(tf_of({{0, opacity}, {1, opacity}}), {{0.25, 0.5, 1}});
      tf.unit_distance = unit;
      const Scene scene = scene_of(volume_of({5, 4, 3}, [](int, int, int) { return 0.5; }), tf);
      const double depth = 4 * mean_depth(opacity, opacity) / unit, alpha = -std::expm1(-depth);
      const OneRay ray = along(scene, {-3, 1.3, 0.6}, {2, 1.3, 0.6}, Answer::integral);
      expect_light(ray.color, alpha * glm::dvec3(0.25, 0.5, 1), alpha);
      EXPECT_NEAR(ray.color.a / alpha, 1, 1e-12) << opacity << " " << unit;  // the smallest too
    }
}

// Along the diagonal of a square every parallel ray's length is known: that of the diagonal, less twice as
// much as it runs beside it. The eye may be anywhere on its line.
TEST(ReferenceClosedForm, ParallelRaysThroughASquare) {
  TransferFunction tf = colored(tf_of({{0, 0.5}, {1, 0.5}}), {white});
  tf.unit_distance = 3;
  const Scene scene = scene_of(volume_of({5, 5, 3}, [](int, int, int) { return 0.5; }), tf);
  const glm::ivec2 size(24, 12);
  const double half_height = 2.5, pixel = 2 * half_height / size.y;
  for (const double before : {-4.0, 1.0, 3.0, 50.0}) {
    Camera camera =
        one_ray({2, 2, 1}, glm::dvec3(2, 2, 1) + glm::dvec3(std::abs(before) / std::sqrt(2.0),
                                                            std::abs(before) / std::sqrt(2.0), 0));
    camera.projection = Projection::parallel;
    if (before < 0) std::swap(camera.eye, camera.target);
    camera.fov_y_degrees = 360 / std::numbers::pi * std::atan(half_height / std::abs(before));
    const Reference picture = render_reference(scene, camera, size, Answer::integral, 1e-10);
    int met = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const double aside = std::abs(x + 0.5 - size.x / 2) * pixel, up = (y + 0.5 - size.y / 2) * pixel;
        const double length = std::abs(up) < 1 ? std::max(0.0, 4 * std::sqrt(2.0) - 2 * aside) : 0;
        EXPECT_NEAR(picture.pixels[std::size_t(y * size.x + x)].a,
                    -std::expm1(-length * std::numbers::ln2 / 3), exact)
            << before << ": " << x << ", " << y;
        met += length > 0;
      }
    EXPECT_GT(met, 40);
  }
}

TEST(ReferenceClosedForm, PlateauOfFullOpacity) {
  for (const double unit : {1.0, 100.0, 1e6}) {
    TransferFunction tf = tf_of({{2, 0}, {2, 1}, {6, 1}, {6, 0}});
    tf.unit_distance = unit;
    const double alpha = -std::expm1(-4 * capped_depth / unit);
    expect_light(through_x(scene_of(ramp_along_x(), tf), Answer::integral).color, alpha * white, alpha);
  }
}

TEST(ReferenceClosedForm, RampsUpAndDown) {
  for (const auto& [from, to] :
       {std::pair(0.0, 0.5), {0.5, 0.0}, {0.0, 1.0}, {1.0, 0.0}, {0.25, 1.0}, {1.0, 0.999}})
    for (const double unit : {0.1, 3.0, 50.0, 1e8}) {
      TransferFunction tf = tf_of({{0, from}, {8, to}});
      tf.unit_distance = unit;
      const double alpha = -std::expm1(-8 * mean_depth(from, to) / unit);
      const glm::dvec4 found = through_x(scene_of(ramp_along_x(), tf), Answer::integral).color;
      expect_light(found, alpha * white, alpha);
      EXPECT_NEAR(found.a / alpha, 1, 1e-9);
    }
}

// A ramp of red to full opacity, and what shines through it: a plateau of green, and blue behind it.
TEST(ReferenceClosedForm, EmissionThroughAnAbsorbingRamp) {
  TransferFunction tf =
      colored(tf_of({{1, 0}, {4, 1}, {4, 0.75}, {6, 0.75}, {6, 0.125}}), {red, red, green, green, blue});
  for (const double unit : {0.5, 2.0, 20.0, 400.0}) {
    tf.unit_distance = unit;
    const double through_red = std::exp(-3 * mean_depth(0, 1) / unit),
                 through_green = std::exp(-2 * mean_depth(0.75, 0.75) / unit),
                 through_blue = std::exp(-2 * mean_depth(0.125, 0.125) / unit);
    const Scene scene = scene_of(ramp_along_x(), tf);
    expect_light(through_x(scene, Answer::integral).color,
                 {1 - through_red, through_red * (1 - through_green),
                  through_red * through_green * (1 - through_blue)},
                 1 - through_red * through_green * through_blue);
    // and from behind
    expect_light(along(scene, {12, 0.7, 1.3}, {4, 0.7, 1.3}, Answer::integral).color,
                 {through_blue * through_green * (1 - through_red), through_blue * (1 - through_green),
                  1 - through_blue},
                 1 - through_red * through_green * through_blue);
  }
}

// The colour changes along a ramp that reaches full opacity: what is left is one integral, solved by another
// rule in a longer format.
TEST(ReferenceClosedForm, ColourChangesAlongARampToFullOpacity) {
  using Real = long double;
  boost::math::quadrature::tanh_sinh<Real> quadrature;
  const auto depth_up_to = [](Real a) { return a < 1 ? a + (1 - a) * std::log1p(-a) : Real(1); };
  for (const double unit : {0.25, 4.0, 64.0}) {
    TransferFunction tf = colored(tf_of({{0, 0}, {8, 1}}), {red, blue});
    tf.unit_distance = unit;
    // From front to back: the blue part is the integral of a dT, by parts
    const Real k = Real(8) / Real(unit), end = std::exp(-k);
    const Real passed =
        quadrature.integrate([&](Real a) { return std::exp(-k * depth_up_to(a)); }, Real(0), Real(1));
    const double alpha = double(1 - end), blue_light = double(passed - end);
    // The cap takes the last 2^-24 of the depth
    const double cap = 0x1p-24 * double(k * end);
    const Scene scene = scene_of(ramp_along_x(), tf);
    expect_light(through_x(scene, Answer::integral).color, {alpha - blue_light, 0, blue_light - cap},
                 alpha - cap);
    // From the back: the depth from full opacity down
    const Real passed_back = quadrature.integrate(
        [&](Real a) { return std::exp(-k * (Real(1 - 0x1p-24L) - depth_up_to(a))); }, Real(0), Real(1));
    const double red_back = double(passed_back - end);
    expect_light(along(scene, {12, 0.7, 1.3}, {4, 0.7, 1.3}, Answer::integral).color,
                 {red_back - cap, 0, alpha - red_back}, alpha - cap);
  }
}

TEST(ReferenceClosedForm, PlanesInOrder) {
  TransferFunction tf =
      colored(tf_of({{0, 0}, {2, 0}, {2, 0.25}, {2, 0}, {4.5, 0}, {4.5, 0.5}, {4.5, 0}, {8, 0}}),
              {white, white, red, white, white, green, white, white});
  const Scene scene = scene_of(ramp_along_x(), tf);
  for (const Answer answer :
       {Answer::crossings, Answer::integral_and_crossings, Answer::base_and_crossings}) {
    const OneRay there = through_x(scene, answer), back = along(scene, {12, 1, 1}, {4, 1, 1}, answer);
    expect_light(there.color, {0.25, 0.75 * 0.5, 0}, 1 - 0.75 * 0.5);
    expect_light(back.color, {0.5 * 0.25, 0.5, 0}, 1 - 0.75 * 0.5);
    EXPECT_EQ(there.crossings, 2);
    EXPECT_EQ(back.crossings, 2);
  }
  EXPECT_EQ(through_x(scene, Answer::integral).color, glm::dvec4(0));
}

// A plane in a medium: the ray absorbs before it and after it.
TEST(ReferenceClosedForm, PlanesInAMedium) {
  TransferFunction tf =
      colored(tf_of({{0, 0.5}, {4, 0.5}, {4, 0.75}, {4, 0.5}, {8, 0.5}}), {red, red, green, red, red});
  tf.unit_distance = 5;
  const double half = std::exp(-4 * std::numbers::ln2 / 5);
  const Scene scene = scene_of(ramp_along_x(), tf);
  for (const Answer answer : {Answer::integral_and_crossings, Answer::base_and_crossings})
    expect_light(through_x(scene, answer).color, {1 - half + half * 0.25 * (1 - half), half * 0.75, 0},
                 1 - half * 0.25 * half);
  expect_light(through_x(scene, Answer::integral).color, {1 - half * half, 0, 0}, 1 - half * half);
}

// A spike's own body is in `integral`, not in `base+crossings`.
TEST(ReferenceClosedForm, FourAnswersOfASpike) {
  const double width = 0.04;
  TransferFunction tf = tf_of({{0, 0}, {3 - width, 0}, {3, 0.5}, {3 + width, 0}, {8, 0.0}});
  const Scene scene = scene_of(ramp_along_x(), tf);
  const double body = std::exp(-2 * width * mean_depth(0, 0.5)), half_body = std::sqrt(body);
  EXPECT_NEAR(through_x(scene, Answer::integral).color.a, 1 - body, exact);
  EXPECT_NEAR(through_x(scene, Answer::crossings).color.a, 0.5, exact);
  EXPECT_NEAR(through_x(scene, Answer::integral_and_crossings).color.a, 1 - half_body * 0.5 * half_body,
              exact);
  EXPECT_NEAR(through_x(scene, Answer::base_and_crossings).color.a, 0.5, exact);
}

// The opacity that a spike has in `integral` is in proportion to its width: known to 1e-6 of itself down to
// 1e-12 of the range, along an axis and aslant.
TEST(ReferenceClosedForm, OpacityOfEverNarrowerSpikes) {
  const auto axis = ramp_along_x(), slanted = sum_of_coordinates();
  for (const double peak : {0.25, 1.0})
    for (const double center : {3.0, 4.625, 5.3})
      for (double relative = 1e-1; relative > 5e-13; relative /= 10) {
        const double half = 4 * relative;
        const TransferFunction tf =
            tf_of({{0, 0}, {center - half, 0}, {center, peak}, {center + half, 0}, {20, 0}});
        const double width =
            (tf.points[3].value - tf.points[2].value) + (tf.points[2].value - tf.points[1].value);
        const auto expect_alpha = [&](const Scene& scene, glm::dvec3 eye, glm::dvec3 target) {
          const glm::dvec3 d = glm::normalize(target - eye);
          const double slope = scene.volume == axis ? d.x : d.x + d.y + d.z;
          const double alpha = -std::expm1(-width / std::abs(slope) * mean_depth(0, peak));
          EXPECT_NEAR(along(scene, eye, target, Answer::integral).color.a / alpha, 1, 1e-6)
              << "width " << relative << " at " << center << ", peak " << peak << ", slope " << slope;
        };
        expect_alpha(scene_of(axis, tf), {-5, 0.7, 1.3}, {4, 0.7, 1.3});
        expect_alpha(scene_of(axis, tf), {15, 1, 1}, {4, 1, 1});
        expect_alpha(scene_of(axis, tf), {-2.3, 0.4, 0.9}, {4, 1.1, 1.2});
        expect_alpha(scene_of(slanted, tf), {-7, -7, 1.25}, {4, 4, 1.25});
        expect_alpha(scene_of(slanted, tf), {-3.1, -2.2, 0.31}, {4, 4, 1.17});
        expect_alpha(scene_of(slanted, tf), {-3, 1.5, 1}, {5, 1.5, 1});
      }
}

// The numbers' size is of no account: nor is an offset, as far as float32 holds the field.
TEST(ReferenceClosedForm, AnySizeOfValues) {
  for (const auto& [scale, offset] : {std::pair(0x1p-100, 0.0), {0x1p100, 0.0}, {1.0, 0x1p20}}) {
    const auto at = [&](double v) { return offset + scale * v; };
    const auto volume = volume_of({9, 3, 3}, [&](int i, int, int) { return at(i); });
    TransferFunction tf = tf_of({{at(1), 0}, {at(3), 0.75}, {at(5), 0}});
    tf.points[1].surface.mode = SurfaceMode::on;
    const double half = std::exp(-2 * mean_depth(0, 0.75));
    const OneRay ray = through_x(scene_of(volume, tf), Answer::integral_and_crossings);
    EXPECT_EQ(ray.crossings, 1);
    EXPECT_NEAR(ray.color.a, 1 - half * 0.25 * half, exact);
  }
}

}  // namespace
}  // namespace crest::testing
