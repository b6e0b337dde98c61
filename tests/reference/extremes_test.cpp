#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/raycaster/brute_force.h"
#include "tests/reference/rays.h"

// Stiff materials, cameras far off and within, boxes like needles, corners.
namespace crest::testing {
namespace {

using boost::math::gamma_p;
constexpr glm::dvec3 red{1, 0, 0}, blue{0, 0, 1};

/// One material whose colour goes from red to blue, of optical depth `depth` over `length`.
TransferFunction red_to_blue(double low, double high, double depth, double length) {
  TransferFunction tf = colored(tf_of({{low, 0.5}, {high, 0.5}}), {red, blue});
  tf.unit_distance = length * std::numbers::ln2 / depth;
  return tf;
}

void expect_relative(double found, double expected, double tolerance) {
  EXPECT_NEAR(found / expected, 1, tolerance) << found << " " << expected;
}

TEST(ReferenceExtremes, EighteenDecadesOfExtinctionOnARamp) {
  const auto volume = volume_of({9, 3, 3}, [](int i, int, int) { return i; });
  for (double depth = 1e-9; depth < 2e9; depth *= 10) {
    SCOPED_TRACE(depth);
    const Scene scene = scene_of(volume, red_to_blue(0, 8, depth, 8));
    const glm::dvec4 there = along(scene, {-5, 0.7, 1.3}, {4, 0.7, 1.3}, Answer::integral).color;
    const glm::dvec4 back = along(scene, {15, 0.7, 1.3}, {4, 0.7, 1.3}, Answer::integral).color;
    // The far colour: integral of x D exp(-D x), x from 0 to 1
    const double alpha = -std::expm1(-depth), far = gamma_p(2, depth) / depth;
    expect_relative(there.a, alpha, 1e-9);
    expect_relative(there.b, far, 1e-9);
    expect_relative(back.r, far, 1e-9);
    EXPECT_NEAR(there.r, alpha - far, 1e-10);
  }
}

// Along the other diagonal of a face x y is s (1 - s): up to 1/4, and down again.
TEST(ReferenceExtremes, EighteenDecadesOfExtinctionOnAHill) {
  const auto volume = volume_of({2, 2, 2}, [](int i, int j, int) { return i * j; });
  for (double depth = 1e-9; depth < 2e9; depth *= 10) {
    SCOPED_TRACE(depth);
    const Scene scene = scene_of(volume, red_to_blue(0, 0.25, depth, std::numbers::sqrt2));
    const glm::dvec4 found = along(scene, {-1, 2, 0.5}, {2, -1, 0.5}, Answer::integral).color;
    const double expected = 4 * (gamma_p(2, depth) - 2 * gamma_p(3, depth) / depth) / depth;
    expect_relative(found.a, -std::expm1(-depth), 1e-9);
    expect_relative(found.b, expected, 1e-8);
  }
}

TEST(ReferenceExtremes, AThousandPoints) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  TransferFunction tf;
  for (int i = 0; i < 1000; ++i) {
    tf.points.emplace_back();
    tf.points.back().value = 8 * unit(random);
    tf.points.back().opacity = 0.9 * unit(random);
  }
  std::ranges::sort(tf.points, {}, &ControlPoint::value);
  tf.unit_distance = 4;
  const auto depth_up_to = [](double a) { return a + (1 - a) * std::log1p(-a); };
  const auto depth_at = [](const ControlPoint& p) { return -std::log1p(-p.opacity); };
  const auto &first = tf.points.front(), &last = tf.points.back();
  double depth = first.value * depth_at(first) + (8 - last.value) * depth_at(last);
  std::size_t peaks = 0;
  for (std::size_t i = 1; i < tf.points.size(); ++i) {
    const auto &a = tf.points[i - 1], &b = tf.points[i];
    depth +=
        (b.value - a.value) * (depth_up_to(b.opacity) - depth_up_to(a.opacity)) / (b.opacity - a.opacity);
    if (i + 1 < tf.points.size()) peaks += b.opacity > a.opacity && b.opacity > tf.points[i + 1].opacity;
  }
  ASSERT_GT(peaks, 300u);
  const Scene scene = scene_of(volume_of({9, 3, 3}, [](int i, int, int) { return i; }), tf);
  EXPECT_NEAR(along(scene, {-5, 0.7, 1.3}, {4, 0.7, 1.3}, Answer::integral).color.a, -std::expm1(-depth / 4),
              1e-10);
  EXPECT_EQ(along(scene, {-5, 0.7, 1.3}, {4, 0.7, 1.3}, Answer::crossings).crossings, int(peaks));
}

/// On a linear field, with one straight line of opacities and surfaces on it, every ray can be written down.
class LinearField {
 public:
  explicit LinearField(glm::ivec3 dims, glm::dvec3 spacing = glm::dvec3(1))
      : volume_(volume_of(
            dims, [](int i, int j, int k) { return i + 2 * j + 3 * k; }, spacing)) {
    most_ = volume_->statistics.range.max;
    tf_ = tf_of({{0, 0}, {most_ / 3, 0.3}, {most_ / 2, 0.45}, {most_, 0.9}});
    tf_.points[1].surface.mode = tf_.points[2].surface.mode = SurfaceMode::on;
    tf_.unit_distance = glm::length(volume_->grid.box_size()) / 3;
  }
  const Grid& grid() const { return volume_->grid; }
  Scene scene() const { return scene_of(volume_, tf_); }

  /// Compares each pixel; returns how many met the box.
  int expect_exact(const Camera& camera, glm::ivec2 size, double tolerance) const {
    const Reference integral = render_reference(scene(), camera, size, Answer::integral);
    const Reference crossings = render_reference(scene(), camera, size, Answer::crossings);
    int hits = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const BruteRay ray = brute_ray(camera, grid(), size, x, y);
        const std::size_t index = std::size_t(y * size.x + x);
        const bool is_hit = ray.exit > ray.enter;
        hits += is_hit;
        EXPECT_NEAR(integral.pixels[index].a, is_hit ? opacity_of(ray) : 0, tolerance) << x << " " << y;
        EXPECT_EQ(int(crossings.crossings[index]), is_hit ? crossings_of(ray) : 0) << x << " " << y;
      }
    return hits;
  }

 private:
  double field(glm::dvec3 place) const {
    return glm::dot(place * grid().smallest_spacing() / grid().spacing, glm::dvec3(1, 2, 3));
  }
  double opacity_of(const BruteRay& ray) const {
    const auto depth = [&](double t) {
      return -std::log1p(-0.9 * field(ray.origin + t * ray.direction) / most_);
    };
    const double sum = boost::math::quadrature::gauss<double, 30>::integrate(depth, ray.enter, ray.exit);
    return -std::expm1(-sum * grid().smallest_spacing() / tf_.unit_distance);
  }
  int crossings_of(const BruteRay& ray) const {
    const double first = field(ray.origin + ray.enter * ray.direction),
                 last = field(ray.origin + ray.exit * ray.direction);
    int count = 0;
    for (const double v : {tf_.points[1].value, tf_.points[2].value}) count += (first < v) != (last < v);
    return count;
  }

  std::shared_ptr<const Volume> volume_;
  TransferFunction tf_;
  double most_;
};

Camera looking(glm::dvec3 eye, glm::dvec3 target, double fov_y_degrees) {
  return {.eye = eye, .target = target, .up = {0.1, 0.2, 1}, .fov_y_degrees = fov_y_degrees, .unknown = {}};
}

TEST(ReferenceExtremes, EyesInsideAndOnTheBox) {
  const LinearField field({7, 6, 5});
  const glm::ivec2 size(12, 9);
  const int all = size.x * size.y;
  EXPECT_EQ(field.expect_exact(looking({2.3, 3.1, 1.7}, {3, 1, 2}, 70), size, 1e-10), all);
  EXPECT_EQ(field.expect_exact(looking({3, 2, 1}, {4, 2, 1}, 70), size, 1e-10), all);  // at a grid point
  EXPECT_EQ(field.expect_exact(looking({0, 2.5, 1.5}, {3, 2, 2}, 70), size, 1e-10), all);
  EXPECT_EQ(field.expect_exact(looking({0, 2.5, 1.5}, {-3, 2, 2}, 70), size, 1e-10), 0);
  EXPECT_EQ(field.expect_exact(looking({6, 5, 4}, {3, 2, 2}, 20), size, 1e-10), all);
  EXPECT_EQ(field.expect_exact(looking({6, 5, 4}, {9, 8, 6}, 20), size, 1e-10), 0);
}

TEST(ReferenceExtremes, EyesAMillionDiagonalsAway) {
  const LinearField field({7, 6, 5});
  const double diagonal = glm::length(field.grid().box_size());
  const glm::dvec3 middle(3, 2.5, 2);
  const Scene scene = field.scene();
  for (const glm::dvec3 from : {glm::dvec3(1, 0, 0), {0.3, -0.8, 0.45}, {-1, 1, 1}, {0.01, 0.02, -1}}) {
    const glm::dvec3 direction = glm::normalize(from);
    const OneRay near = along(scene, middle + 20.0 * direction, middle, Answer::integral_and_crossings),
                 far = along(scene, middle + 1e6 * diagonal * direction, middle,
                             Answer::integral_and_crossings);
    EXPECT_NEAR(far.color.a, near.color.a, 1e-9);  // the eye itself is rounded to 1e-9
    EXPECT_EQ(far.crossings, near.crossings);
  }
}

TEST(ReferenceExtremes, NarrowAndWideFieldsOfView) {
  const LinearField field({7, 6, 5});
  const glm::ivec2 size(16, 12);
  EXPECT_GT(field.expect_exact(whole_volume_camera(field.grid(), 1, 0.001), size, 1e-8), 40);
  EXPECT_EQ(field.expect_exact(looking({-300, 10, 20}, {3, 2.5, 2}, 0.001), size, 1e-9), 16 * 12);
  EXPECT_EQ(field.expect_exact(looking({3.2, 2.1, 1.9}, {5, 3, 2}, 170), size, 1e-10), 16 * 12);
  EXPECT_GT(field.expect_exact(looking({-0.2, 2.1, 1.9}, {5, 3, 2}, 170), size, 1e-10), 4);
}

TEST(ReferenceExtremes, NeedlesAndPlates) {
  for (const auto& [dims, spacing] : {std::pair(glm::ivec3(2, 2, 500), glm::dvec3(1, 1, 1000)),
                                      {{2, 2, 500}, {1, 1, 1e-3}},
                                      {{300, 2, 3}, {1e-4, 1, 1e4}}}) {
    const LinearField field(dims, spacing);
    const glm::dvec3 box = field.grid().box_size();
    SCOPED_TRACE(dims.z);
    const glm::dvec3 aside = 0.9 * std::max(box.x, box.y) * glm::dvec3(-0.3, -1, 0.1);
    EXPECT_GT(field.expect_exact(looking(0.5 * box + aside, 0.5 * box, 30), {24, 16}, 1e-9), 5);
    // through all of its length
    const glm::dvec3 start = 0.5 * box - glm::dvec3(0, 0, 0.6 * box.z);
    EXPECT_GT(field.expect_exact(looking(start, 0.5 * box, 1e-3), {5, 4}, 1e-9), 3);
    EXPECT_GT(field.expect_exact(looking(0.3 * box, 0.8 * box, 60), {16, 12}, 1e-9), 5);
  }
}

TEST(ReferenceExtremes, RaysThatOnlyTouchTheBox) {
  const LinearField field({7, 6, 5});
  const Scene scene = field.scene();
  const auto expect_nothing = [&](glm::dvec3 eye, glm::dvec3 target) {
    const OneRay ray = along(scene, eye, target, Answer::integral_and_crossings);
    EXPECT_EQ(ray.color, glm::dvec4(0));
    EXPECT_EQ(ray.crossings, 0);
    EXPECT_TRUE(ray.grazing);
  };
  expect_nothing({-1, 1, 0}, {1, -1, 0});   // a corner
  expect_nothing({-1, 1, 2}, {1, -1, 2});   // an edge
  expect_nothing({7, 4, 5}, {5, 6, 3});     // the last corner
  expect_nothing({0, 0, 0}, {-1, -1, -1});  // away from it
  // A ray in an edge is in the box, all the way.
  EXPECT_GT(along(scene, {-1, 0, 0}, {1, 0, 0}, Answer::integral).color.a, 0.01);
}

}  // namespace
}  // namespace crest::testing
