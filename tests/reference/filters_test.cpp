#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "presets/names.h"
#include "render/classify/classification.h"
#include "render/scene/camera.h"
#include "tests/raycaster/brute_force.h"
#include "tests/raycaster/reconstruct.h"
#include "tests/reference/rays.h"

// The exact answers of the fields of other filters.
namespace crest::testing {
namespace {

constexpr glm::ivec2 size{6, 6};

Rendering with_filters(Filter filter, std::optional<Filter> root = {}, double b = 0, double c = 0.5) {
  Rendering rendering;
  rendering.filter = filter;
  rendering.root_filter = root;
  rendering.bc_b = b;
  rendering.bc_c = c;
  return rendering;
}

/// Midpoint sums, with the surfaces where the root filter's field changes its side between two samples.
struct Sampled {
  glm::dvec4 color{0};
  int crossings = 0;
};

Sampled sample(const Scene& scene, const TransferFunction& tf, const std::vector<Peak>& surfaces,
               const BruteRay& ray, int n) {
  Sampled result;
  double transmittance = 1, before = 0;
  const auto collect = [&](glm::dvec3 color, double alpha) {
    result.color += transmittance * alpha * glm::dvec4(color, 1);
    transmittance *= 1 - alpha;
  };
  const double dt = (ray.exit - ray.enter) / n;
  for (int i = 0; i < n && ray.hits(); ++i) {
    const glm::dvec3 place = ray.origin + (ray.enter + (i + 0.5) * dt) * ray.direction;
    const double root = reconstruct(*scene.volume, root_filter(scene.rendering), place);
    for (std::size_t k = 0; i > 0 && k < surfaces.size(); ++k) {
      const Peak& peak = surfaces[root > before ? k : surfaces.size() - 1 - k];
      if ((before >= peak.value) == (root >= peak.value)) continue;
      collect(peak.color, peak.opacity);
      ++result.crossings;
    }
    before = root;
    const Classified at = evaluate(tf, reconstruct(*scene.volume, dvr_filter(scene.rendering), place));
    collect(at.color, -std::expm1(-extinction(at.opacity, tf.unit_distance) *
                                  scene.volume->grid.smallest_spacing() * dt));
  }
  return result;
}

void expect_as_sampled(const Scene& scene, double tolerance) {
  const Camera camera = whole_volume_camera(scene.volume->grid, 1, 40);
  const Classification classified = classify(scene.tf, surface_range(scene));
  for (const Answer answer : {Answer::integral, Answer::crossings, Answer::base_and_crossings}) {
    TransferFunction tf = scene.tf;
    if (answer == Answer::crossings) tf.points.clear();
    if (answer == Answer::base_and_crossings) tf = base_transfer_function(tf, classified.peaks);
    const auto surfaces = answer == Answer::integral ? std::vector<Peak>{} : classified.surfaces;
    const Reference picture = render_reference(scene, camera, size, answer);
    double worst = 0;
    int miscounted = 0;
    for (int index = 0; index < size.x * size.y; ++index) {
      const auto ray = brute_ray(camera, scene.volume->grid, size, index % size.x, index / size.x);
      const Sampled found = sample(scene, tf, surfaces, ray, 2000);
      if (int(picture.crossings[std::size_t(index)]) != found.crossings) {  // both sides of a tangent
        ++miscounted;
        continue;
      }
      const glm::dvec4 off = glm::abs(picture.pixels[std::size_t(index)] - found.color);
      worst = std::max({worst, off.r, off.g, off.b, off.a});
    }
    EXPECT_LT(worst, tolerance) << name_of(answer);
    EXPECT_LE(miscounted, 1) << name_of(answer);
  }
}

std::shared_ptr<const Volume> random_volume(std::mt19937& random) {
  std::uniform_real_distribution<float> unit(0, 1);
  return volume_of({4, 5, 3}, [&](int, int, int) { return random() % 4 ? unit(random) : 0.5f; }, {1, 0.5, 2},
                   {-3, 10, 0.25});
}

TEST(ReferenceFilters, AreAsTheirFieldsSampledFinely) {
  std::mt19937 random(11);
  const Rendering renderings[] = {with_filters(Filter::bspline), with_filters(Filter::bc),
                                  with_filters(Filter::bc, {}, 2, 1), with_filters(Filter::linear_exact)};
  for (const Rendering& rendering : renderings) {
    Scene scene = scene_of(random_volume(random), random_tf(random, 9));
    scene.rendering = rendering;
    SCOPED_TRACE(name_of(rendering.filter));
    expect_as_sampled(scene, 5e-3);
  }
}

// What is integrated, and the field in which surfaces lie, of different filters.
TEST(ReferenceFilters, OfRootsAndOfSamplesMayDiffer) {
  std::mt19937 random(5);
  const Rendering renderings[] = {with_filters(Filter::linear, Filter::bspline),
                                  with_filters(Filter::bspline, Filter::linear),
                                  with_filters(Filter::bspline, Filter::bc)};
  for (const Rendering& rendering : renderings) {
    TransferFunction tf = tf_of({{0, 0.3}, {0.4, 0.1}, {0.45, 0.7}, {0.5, 0.1}, {0.7, 0.2}, {0.8, 0.1}});
    tf.unit_distance = 4;
    Scene scene = scene_of(random_volume(random), colored(tf, {{1, 0.2, 0}, {0, 0.5, 1}}));
    scene.rendering = rendering;
    SCOPED_TRACE(name_of(rendering.filter));
    expect_as_sampled(scene, 5e-3);
  }
}

// With two filters of one field, the ways of one field and of two agree as nearly as both are solved.
TEST(ReferenceFilters, TwoFieldsThatAreEqualGiveWhatOneDoes) {
  std::mt19937 random(3);
  for (int round = 0; round < 4; ++round) {
    Scene scene = scene_of(random_volume(random), random_tf(random, 7));
    const Camera camera = whole_volume_camera(scene.volume->grid, 1, 40);
    scene.rendering = with_filters(Filter::bspline);
    const Reference one = render_reference(scene, camera, size, Answer::integral_and_crossings);
    scene.rendering = with_filters(Filter::bspline, Filter::bc, 1, 0);
    const Reference two = render_reference(scene, camera, size, Answer::integral_and_crossings);
    EXPECT_EQ(one.crossings, two.crossings);
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
      for (int channel = 0; channel < 4; ++channel)
        EXPECT_NEAR(one.pixels[i][channel], two.pixels[i][channel], 1e-9);
  }
}

constexpr glm::ivec2 fine{24, 24};

/// Sees the whole volume, in the direction in which the fields below rise.
Camera uphill(const Grid& grid) {
  const glm::dvec3 middle = 0.5 * (grid.box_min() + grid.box_max());
  return {.eye = middle + glm::dvec3(-30, -25, 10),
          .target = middle,
          .up = {0, 0, 1},
          .fov_y_degrees = 20,
          .unknown = {}};
}

/// A scene of a volume, of which only what lies two points from its border is rendered: there no support is
/// clamped.
Scene inner_part(std::shared_ptr<const Volume> volume, TransferFunction tf, const Rendering& rendering) {
  Scene scene = scene_of(std::move(volume), std::move(tf));
  scene.rendering = rendering;
  const Grid& grid = scene.volume->grid;
  scene.rendering.clip_box =
      ClipBox{grid.box_min() + 2.0 * grid.spacing, grid.box_max() - 2.0 * grid.spacing, {}};
  return scene;
}

void expect_same(const Reference& a, const Reference& b, double tolerance) {
  EXPECT_EQ(a.crossings, b.crossings);
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 4; ++channel)
      EXPECT_NEAR(a.pixels[i][channel], b.pixels[i][channel], tolerance) << i;
}

// The B-spline, Catmull-Rom and Mitchell and Netravali's own choice give a linear function back, as the
// trilinear filter does.
TEST(ReferenceFilters, OfALinearFunctionAreThatFunction) {
  const auto volume = volume_of(
      {14, 16, 12}, [](int i, int j, int k) { return 0.5 * i + 0.25 * j - 0.125 * k; }, {1, 0.5, 2});
  const TransferFunction tf = tf_of({{3.5, 0}, {4.4, 0.9}, {4.9, 0.1}, {6, 0.2}});
  const Camera camera = uphill(volume->grid);
  const Reference exact = render_reference(inner_part(volume, tf, with_filters(Filter::linear)), camera, fine,
                                           Answer::integral_and_crossings);
  EXPECT_GT(std::ranges::count(exact.crossings, 1u), 40);
  for (const Rendering& rendering :
       {with_filters(Filter::bspline), with_filters(Filter::bc),
        with_filters(Filter::bc, {}, 1.0 / 3, 1.0 / 3), with_filters(Filter::linear, Filter::bspline)})
    expect_same(
        render_reference(inner_part(volume, tf, rendering), camera, fine, Answer::integral_and_crossings),
        exact, 1e-9);
}

// Catmull-Rom gives a quadratic function back, in which the trilinear filter has chords; the B-spline adds
// its variance, 1/3 of a spacing squared.
TEST(ReferenceFilters, OfCatmullRomOfAQuadraticFunctionIsThatFunction) {
  const auto parabola = [](double x, double y, double z) {
    return 0.25 * x * x + 0.5 * x * y - 0.125 * z * z;
  };
  const auto volume = volume_of({14, 16, 12}, parabola);
  const TransferFunction tf = tf_of({{27, 0}, {31, 0.9}, {33, 0.1}, {60, 0.2}});
  const Camera camera = uphill(volume->grid);
  const auto formula = [&](double added) {
    return FormulaField{
        [=](glm::dvec3 p) { return parabola(p.x, p.y, p.z) + added; },
        [](glm::dvec3 p) { return glm::dvec3(0.5 * p.x + 0.5 * p.y, 0.5 * p.x, -0.25 * p.z); }};
  };
  const auto expect_formula = [&](const Rendering& rendering, double added) {
    const Scene scene = inner_part(volume, tf, rendering);
    const Reference exact =
        render_reference(formula(added), scene, camera, fine, Answer::integral_and_crossings);
    EXPECT_GT(std::ranges::count(exact.crossings, 1u), 40);
    expect_same(render_reference(scene, camera, fine, Answer::integral_and_crossings), exact, 1e-9);
  };
  expect_formula(with_filters(Filter::bc), 0);
  expect_formula(with_filters(Filter::bspline), (0.25 - 0.125) / 3);
}

// A point without a value empties the cells that a filter would need it for: eight with the trilinear filter,
// 64 with a cubic one.
TEST(ReferenceFilters, EmptyCellsAreThoseThatReachAPointWithoutAValue) {
  const auto volume = volume_of(
      {9, 9, 9}, [](int i, int j, int k) { return i == 4 && j == 4 && k == 4 ? std::nan("") : 1.0; });
  const double alpha = 0.1;
  Scene scene = scene_of(volume, tf_of({{0, alpha}, {2, alpha}}));
  const auto absorbed = [&](Filter filter) {
    scene.rendering.filter = filter;
    return along(scene, {4.5, 4.5, -5}, {4.5, 4.5, 1}, Answer::integral).color.a;
  };
  EXPECT_NEAR(absorbed(Filter::linear), 1 - std::pow(1 - alpha, 6), 1e-12);
  EXPECT_NEAR(absorbed(Filter::bspline), 1 - std::pow(1 - alpha, 4), 1e-12);
  EXPECT_NEAR(absorbed(Filter::bc), 1 - std::pow(1 - alpha, 4), 1e-12);
}

// A filter with negative weights goes beyond its points: surfaces there are met, too.
TEST(ReferenceFilters, SurfacesBeyondThePointsValuesAreMetWhereAFilterOvershoots) {
  Scene scene =
      scene_of(profile({0, 0, 0, 1, 1, 1}), tf_of({{-1, 0}, {1.02, 0}, {1.03, 0.5}, {1.04, 0}, {2, 0}}));
  const auto crossings = [&](const Rendering& rendering) {
    scene.rendering = rendering;
    return along(scene, {-5, 0.5, 0.5}, {1, 0.5, 0.5}, Answer::crossings).crossings;
  };
  EXPECT_EQ(crossings(with_filters(Filter::linear)), 0);
  EXPECT_EQ(crossings(with_filters(Filter::bspline)), 0);
  EXPECT_EQ(crossings(with_filters(Filter::bc)), 2);
}

}  // namespace
}  // namespace crest::testing
