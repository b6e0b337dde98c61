#include <fmt/core.h>

#include <cmath>
#include <random>

#include "presets/names.h"
#include "render/reference/reference.h"
#include "tests/raycaster/brute_force.h"
#include "tests/raycaster/fixture.h"
#include "tests/raycaster/reconstruct.h"

// The shader's filters against the exact answers of their fields, and their gradients against double.
namespace crest::testing {
namespace {

constexpr glm::ivec2 size{24, 24};

Rendering with_filters(Filter filter, std::optional<Filter> root = {}, double b = 0, double c = 0.5) {
  Rendering rendering;
  rendering.filter = filter;
  rendering.root_filter = root;
  rendering.bc_b = b;
  rendering.bc_c = c;
  return rendering;
}

/// What the TF's table, which is interpolated, leaves (TfTableLimits allows 1e-5).
constexpr double table_floor = 4e-6;

std::string name(const Rendering& rendering) {
  return fmt::format("{}, roots {}, B {:.2g}, C {:.2g}", name_of(rendering.filter),
                     name_of(root_filter(rendering).kind), rendering.bc_b, rendering.bc_c);
}

const Rendering all_filters[] = {with_filters(Filter::linear),
                                 with_filters(Filter::linear_exact),
                                 with_filters(Filter::bspline),
                                 with_filters(Filter::bc),
                                 with_filters(Filter::bc, {}, 1.0 / 3, 1.0 / 3),
                                 with_filters(Filter::bc, {}, 2, 1),
                                 with_filters(Filter::linear, Filter::bspline),
                                 with_filters(Filter::bspline, Filter::bc)};

double wave(glm::dvec3 p) {
  return 0.5 + 0.3 * std::sin(0.9 * p.x + 0.3) * std::cos(0.7 * p.y) + 0.2 * std::sin(1.1 * p.z + 0.4 * p.x);
}

std::shared_ptr<const Volume> wave_volume() {
  return make_volume({{10, 12, 9}, {1, 0.75, 1.25}, {-4, 2, 0.5}}, wave);
}

double rmse(const Image& image, const Image& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (int channel = 0; channel < 4; ++channel)
      sum += std::pow(double(image.pixels[i][channel]) - double(truth.pixels[i][channel]), 2);
  return std::sqrt(sum / double(4 * image.pixels.size()));
}

class Filters : public RaycasterTest {
 protected:
  /// Root mean square errors against the scene's own exact answer.
  std::vector<double> errors(Scene scene, std::initializer_list<double> steps) {
    const Camera camera = whole_volume_camera(scene.volume->grid, 1, 30);
    const Image truth = render_reference(scene, camera, size, answers_of(scene.rendering).front()).image();
    std::vector<double> result;
    for (const double step : steps) {
      scene.rendering.step = step;
      result.push_back(rmse(render(scene, camera, size), truth));
    }
    return result;
  }
};

// Of second order where the TF is smooth, down to the floor of float.
TEST_F(Filters, DvrFallsToTheExactAnswerOfItsField) {
  for (const Rendering& rendering : all_filters) {
    if (rendering.root_filter) continue;
    Scene scene{wave_volume(), make_tf({point(-2, 0.02, {1, 0, 0}), point(3, 0.6, {0, 0.5, 1})}, 2),
                rendering};
    scene.rendering.mode = Mode::dvr_only;
    const auto found = errors(scene, {1, 0.5, 0.25, 0.125, 1.0 / 64});
    SCOPED_TRACE(name(rendering) + ": " + ::testing::PrintToString(found));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(found[i + 1], std::max(0.4 * found[i], table_floor));
    EXPECT_GT(found.front(), 10 * table_floor);
    EXPECT_LT(found.back(), table_floor);
  }
}

// And with surfaces, in the field of either filter.
TEST_F(Filters, SurfacesInHazeFallToTheExactAnswerOfTheirField) {
  for (const Rendering& rendering : all_filters) {
    Scene scene{wave_volume(),
                make_tf({point(-2, 0.02, {1, 0, 0}), point(0.399, 0.1), point(0.4, 0.6, {1, 1, 0}),
                         point(0.401, 0.1), point(0.649, 0.1), point(0.65, 0.7, {0, 1, 1}), point(0.651, 0.1),
                         point(3, 0.3, {0, 0.5, 1})},
                        2),
                rendering};
    scene.rendering.mode = Mode::peak_xor_dvr;
    const auto found = errors(scene, {1, 0.25, 1.0 / 16, 1.0 / 128});
    SCOPED_TRACE(name(rendering) + ": " + ::testing::PrintToString(found));
    for (std::size_t i = 0; i + 1 < found.size(); ++i)
      EXPECT_LT(found[i + 1], std::max(0.2 * found[i], table_floor));
    EXPECT_GT(found.front(), 10 * table_floor);
    EXPECT_LT(found.back(), table_floor);
  }
}

/// The light of a headlight on a field of this gradient.
double light(glm::dvec3 gradient, glm::dvec3 direction) {
  return 0.25 + 0.75 * std::abs(glm::dot(glm::normalize(gradient), direction));
}

/// In double, at a position in smallest spacings: the filter's own derivative (its field is smooth over a
/// millionth of a cell, but for the trilinear's faces), or central differences of one voxel, one-sided at the
/// box's faces.
glm::dvec3 gradient(const Volume& volume, const FieldFilter& filter, Gradient kind, glm::dvec3 p) {
  const glm::dvec3 cell = volume.grid.spacing / volume.grid.smallest_spacing();
  glm::dvec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    const double h = cell[axis] * (kind == Gradient::central ? 1 : 1e-6);
    glm::dvec3 low = p, high = p;
    low[axis] = std::max(p[axis] - h, 0.0);
    high[axis] = std::min(p[axis] + h, cell[axis] * (volume.grid.dims[axis] - 1));
    result[axis] =
        (reconstruct(volume, filter, high) - reconstruct(volume, filter, low)) / (high[axis] - low[axis]);
  }
  return result;
}

/// Whether a place is so near to a cell's face that float may take it for one beyond.
bool is_near_face(const Volume& volume, glm::dvec3 p) {
  const glm::dvec3 cells = p * volume.grid.smallest_spacing() / volume.grid.spacing;
  const glm::dvec3 off = glm::abs(cells - glm::round(cells));
  return std::min({off.x, off.y, off.z}) < 1e-3;
}

// So dense a haze that the first sample is all that shows: half a step behind the entry. With a surface in
// sight, the field of DVR is not that of the surfaces.
TEST_F(Filters, LightOfASampleIsThatOfItsOwnFieldsGradient) {
  const auto volume = wave_volume();
  const Camera camera = whole_volume_camera(volume->grid, 1, 30);
  for (const Gradient kind : {Gradient::central, Gradient::filter})
    for (const Rendering& rendering : all_filters) {
      Scene scene{
          volume,
          make_tf({point(-3, 1), point(0.6, 0.999), point(0.6, 1), point(0.6, 0.999), point(3, 1)}, 1e-3),
          rendering};
      scene.rendering.mode = Mode::both;
      scene.rendering.shading = Shading::gradient;
      scene.rendering.gradient = kind;
      scene.rendering.step = 1;
      const Image image = render(scene, camera, size);
      double worst = 0;
      int compared = 0;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const BruteRay ray = brute_ray(camera, volume->grid, size, x, y);
          const double length = ray.exit - ray.enter;
          if (!ray.hits() || length < 2) continue;
          const glm::dvec3 at = ray.origin + (ray.enter + 0.5 * length / std::ceil(length)) * ray.direction;
          if (is_near_face(*volume, at)) continue;
          const double root0 =
              reconstruct(*volume, root_filter(rendering), ray.origin + ray.enter * ray.direction);
          const double root1 = reconstruct(*volume, root_filter(rendering), at);
          if ((root0 >= 0.6) != (root1 >= 0.6)) continue;  // the surface lies before the sample
          const double expected = light(gradient(*volume, dvr_filter(rendering), kind, at), ray.direction);
          worst = std::max(worst, std::abs(double(image.pixels[std::size_t(y * size.x + x)].r) - expected));
          ++compared;
        }
      EXPECT_GT(compared, 100);
      EXPECT_LT(worst, 3e-4) << name(rendering) << ", " << name_of(kind);
    }
}

// The same at opaque surfaces, in the root filter's field.
TEST_F(Filters, LightOfASurfaceIsThatOfTheRootFiltersGradient) {
  const auto volume = wave_volume();
  const Camera camera = whole_volume_camera(volume->grid, 1, 30);
  const double isovalue = 0.55;
  for (const Gradient kind : {Gradient::central, Gradient::filter})
    for (const Rendering& rendering : all_filters) {
      Scene scene{
          volume,
          make_tf({point(-3, 0), point(isovalue, 0), point(isovalue, 1), point(isovalue, 0), point(3, 0)}),
          rendering};
      scene.rendering.mode = Mode::peak_only;
      scene.rendering.shading = Shading::gradient;
      scene.rendering.gradient = kind;
      scene.rendering.step = 0.05;
      const Image image = render(scene, camera, size);
      int compared = 0, off = 0;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const BruteRay ray = brute_ray(camera, volume->grid, size, x, y);
          const auto value = [&](double t) {
            return reconstruct(*volume, root_filter(rendering), ray.origin + t * ray.direction) - isovalue;
          };
          double low = ray.enter, high = ray.enter;
          while (high < ray.exit && (value(low) >= 0) == (value(high) >= 0)) high += 0.01;
          if (!ray.hits() || high >= ray.exit) continue;
          for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            ((value(middle) >= 0) == (value(low) >= 0) ? low : high) = middle;
          }
          const glm::dvec3 at = ray.origin + low * ray.direction;
          if (is_near_face(*volume, at)) continue;
          const double expected = light(gradient(*volume, root_filter(rendering), kind, at), ray.direction);
          off += std::abs(double(image.pixels[std::size_t(y * size.x + x)].r) - expected) > 1e-3;
          ++compared;
        }
      EXPECT_GT(compared, 100);
      EXPECT_LE(off, compared / 100) << name(rendering) << ", "
                                     << name_of(kind);  // two crossings in one step
    }
}

// r^2 by Catmull-Rom is r^2, and by the B-spline r^2 + 1: so where r^2 = 36 lies is known for both, and a
// trilinear field is above it, by 1/4 of a spacing squared an axis at most.
TEST_F(Filters, ASphereHasTheRadiusThatItsRootFilterGivesIt) {
  const Grid grid{glm::ivec3(21), glm::dvec3(1), glm::dvec3(-10)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return glm::dot(p, p); });
  const Camera camera = along_z(grid, 16);
  const glm::ivec2 fine{96, 96};
  const auto expect_disk = [&](const Rendering& rendering, double smallest, double largest) {
    Scene scene{volume, make_tf({point(0, 0), point(36, 0), point(36, 1), point(36, 0), point(400, 0)}),
                rendering};
    scene.rendering.mode = Mode::peak_only;
    const Image image = render(scene, camera, fine);
    int wrong = 0;
    for (int y = 0; y < fine.y; ++y)
      for (int x = 0; x < fine.x; ++x) {
        const double r = 16.0 / 96 * std::hypot(x + 0.5 - 48, y + 0.5 - 48);
        const bool hit = image.pixels[std::size_t(y * 96 + x)].a > 0.5f;
        wrong += (r < smallest - 0.01 && !hit) || (r > largest + 0.01 && hit);
      }
    EXPECT_EQ(wrong, 0) << name(rendering);
  };
  const double trilinear = std::sqrt(36 - 0.75), bspline = std::sqrt(35.0);
  expect_disk(with_filters(Filter::linear), trilinear, 6);
  expect_disk(with_filters(Filter::linear_exact), trilinear, 6);
  expect_disk(with_filters(Filter::bspline), bspline, bspline);
  expect_disk(with_filters(Filter::linear, Filter::bspline), bspline, bspline);
  expect_disk(with_filters(Filter::bc), 6, 6);
  expect_disk(with_filters(Filter::bspline, Filter::bc), 6, 6);
}

// A part on the value is inside: only where interpolation of equal values gives exactly that value does a
// ray that wanders through it cross the surface once.
TEST_F(Filters, FacesOfEqualValuesStayEqual) {
  const float profile[] = {0, 0, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 1, 1};
  const auto volume = make_volume({{10, 10, 10}, glm::dvec3(1), glm::dvec3(0)},
                                  [&](glm::dvec3 p) { return profile[int(p.x)]; });
  const double value = double(0.1f);
  const TransferFunction tf =
      make_tf({point(-1, 0), point(value, 0), point(value, 0.5), point(value, 0), point(2, 0)});
  Scene scene{volume, tf, with_filters(Filter::linear_exact)};
  scene.rendering.mode = Mode::peak_only;
  scene.rendering.step = 0.07;
  Camera camera = whole_volume_camera(volume->grid, 1, 30);
  camera.eye = {-30, 17, 9};
  gl::RenderTarget target(size, true);
  const Reference exact = render_reference(scene, camera, size, Answer::crossings);
  int several = 0, crossed = 0;
  const auto counts = raycaster.draw_counts(scene, camera, target);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    several += counts[i].crossings > 1;
    crossed += exact.grazing[i] == 0 && counts[i].crossings != exact.crossings[i];
  }
  EXPECT_EQ(several, 0);
  EXPECT_EQ(crossed, 0);
  EXPECT_GT(*std::ranges::max_element(exact.crossings), 0u);
}

// What a wide filter would need a stand-in for is empty.
TEST_F(Filters, CellsThatReachAPointWithoutAValueAreEmpty) {
  const auto volume = make_volume({glm::ivec3(11), glm::dvec3(1), glm::dvec3(0)}, [](glm::dvec3 p) {
    return p == glm::dvec3(5, 4, 6) || p == glm::dvec3(2, 8, 2) ? std::nan("") : wave(p);
  });
  for (const Rendering& rendering : all_filters) {
    Scene scene{volume, make_tf({point(-2, 0.02, {1, 0, 0}), point(3, 0.6, {0, 0.5, 1})}, 2), rendering};
    scene.rendering.mode = Mode::dvr_only;
    EXPECT_LT(errors(scene, {1.0 / 32}).front(), 2e-5) << name(rendering);
  }
}

// A surface at a value that no point has, which a filter's negative weights reach: space is not skipped
// there.
TEST_F(Filters, SkippingLeavesWhatAFilterMakesBeyondThePointsValues) {
  const auto volume = make_volume({glm::ivec3(24), glm::dvec3(1), glm::dvec3(0)}, [](glm::dvec3 p) {
    return glm::distance(p, glm::dvec3(9)) < 4 ? 1.0 : 0.0;
  });
  Scene scene{volume, make_tf({point(-1, 0), point(1.04, 0), point(1.05, 0.8), point(1.06, 0), point(2, 0)}),
              with_filters(Filter::bc)};
  scene.rendering.mode = Mode::peak_xor_dvr;
  scene.rendering.step = 0.2;
  const Camera camera = whole_volume_camera(volume->grid, 1, 30);
  EXPECT_TRUE(raycaster.features(scene, false).skipping);
  const Image skipped = render(scene, camera, size);
  scene.rendering.skipping = false;
  const Image whole = render(scene, camera, size);
  EXPECT_LT(rmse(skipped, whole), 1e-6);
  EXPECT_GT(std::ranges::max(whole.pixels, {}, [](const auto& p) { return p.a; }).a, 0.7f);
}

// One field costs what it costs without a root filter; two cost a sample more where DVR samples.
TEST_F(Filters, NothingIsEvaluatedTwiceWhereTheRootFilterIsTheFilter) {
  const Camera camera = whole_volume_camera(wave_volume()->grid, 1, 30);
  const TransferFunction tf =
      make_tf({point(0, 0.1), point(0.599, 0.1), point(0.6, 0.5), point(0.601, 0.1), point(1, 0.1)});
  const auto counted = [&](const Rendering& rendering) {
    return count(Scene{wave_volume(), tf, rendering}, camera, size);
  };
  const RenderCounts one = counted(with_filters(Filter::bspline));
  EXPECT_EQ(counted(with_filters(Filter::bspline, Filter::bspline)).samples, one.samples);
  const RenderCounts two = counted(with_filters(Filter::linear_exact, Filter::bspline));
  EXPECT_GE(two.samples, one.samples + one.dvr_samples);
  Rendering peaks = with_filters(Filter::linear, Filter::bspline);
  peaks.mode = Mode::peak_only;
  const Features alone = raycaster.features(Scene{wave_volume(), tf, peaks}, false);
  EXPECT_FALSE(alone.own_root_filter);
  EXPECT_FALSE(uses_filter(alone, Filter::linear)) << "DVR's filter, without DVR";
  peaks.mode = Mode::dvr_only;
  EXPECT_FALSE(uses_filter(raycaster.features(Scene{wave_volume(), tf, peaks}, false), Filter::bspline));
}

}  // namespace
}  // namespace crest::testing
