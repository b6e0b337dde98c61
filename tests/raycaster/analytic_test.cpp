// The exact march (rendering.classification analytic) against the exact answer on the CPU.
#include <fmt/core.h>

#include <cstdlib>

#include "presets/choices.h"
#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/measure/image_error.h"
#include "render/reference/reference.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"
#include "tests/raycaster/random_view.h"

namespace crest::testing {
namespace {

constexpr Mode modes[] = {Mode::dvr_only, Mode::peak_only, Mode::peak_xor_dvr, Mode::both};

class Analytic : public RaycasterTest {
 protected:
  struct Drawn {
    Image image;
    std::vector<std::uint32_t> crossings;
  };
  Drawn draw(const Scene& scene, const Camera& camera, glm::ivec2 size) {
    gl::RenderTarget target(size, true);
    Drawn drawn;
    for (const PixelCounts& counts : raycaster.draw_counts(scene, camera, target))
      drawn.crossings.push_back(counts.crossings);
    drawn.image = target.read_color();
    return drawn;
  }

  ImageError error_of(Scene scene, const Camera& camera, glm::ivec2 size) {
    scene.rendering.classification = ClassificationMethod::analytic;
    const ExactAnswer exact = exact_answers_of(scene.rendering).front();
    const Reference truth = render_reference(scene, camera, size, exact.answer, 1e-6);
    const Drawn drawn = draw(scene, camera, size);
    return image_error(truth, drawn.image, drawn.crossings, glm::vec3(0));
  }
};

TEST_F(Analytic, RandomScenesAreExact) {
  double pixels = 0, wrong = 0, crossings = 0, missed = 0, invented = 0, largest = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const View view = analytic_view(seed);
    const ImageError error = error_of(view.scene, view.camera, {24, 24});
    pixels += double(error.compared.pixels);
    wrong += error.compared.share * double(error.compared.pixels);
    if (error.compared.share > 0)
      fmt::print("seed {}: {} of {} wrong, {:.3g} at most ({}), missed {} invented {}\n", seed,
                 std::round(error.compared.share * double(error.compared.pixels)), error.compared.pixels,
                 error.compared.max, name_of(view.scene.rendering.mode), error.crossings->missed,
                 error.crossings->invented);
    largest = std::max(largest, error.compared.max);
    crossings += error.crossings->exact;
    missed += error.crossings->missed;
    invented += error.crossings->invented;
  }
  fmt::print("{} pixels, {} wrong, {} crossings, {} missed, {} invented, largest {}\n", pixels, wrong,
             crossings, missed, invented, largest);
  EXPECT_GT(pixels, 40000);
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(missed + invented, 0);
  EXPECT_LT(largest, 2e-3);
}

/// A ball of label 3 in one of 2, in one of 1, in 0.
std::shared_ptr<const Volume> labels() {
  Grid grid{glm::ivec3(16), glm::dvec3(1, 1.2, 0.9), glm::dvec3(0)};
  const glm::dvec3 middle = 0.5 * grid.box_size();
  return make_volume(grid, [=](glm::dvec3 p) {
    const double r = glm::length(p - middle);
    return r < 2.5 ? 3.0 : r < 4.5 ? 2.0 : r < 6.5 ? 1.0 : 0.0;
  });
}

/// A step to the opacity at each of the values, in colours of their own.
TransferFunction steps_at(std::initializer_list<double> values, double opacity) {
  TransferFunction tf = make_tf({point(-1, 0)}, 2);
  double before = 0;
  for (const double value : values) {
    const glm::dvec3 color(0.2 + 0.2 * value, 1 - 0.3 * value, 0.5);
    tf.points.push_back(point(value, before, color));
    tf.points.push_back(point(value, opacity, color));
    before = opacity / 3;
    tf.points.push_back(point(value + 0.5, before, color));
  }
  return tf;
}

// Regions stay on values at which the TF has a step, or a surface lies: at the value itself the upper side
// holds.
TEST_F(Analytic, LabelsWithStepsAtTheirValues) {
  for (const Mode mode : modes)
    for (const auto& values : {std::initializer_list<double>{1}, {3}, {1, 2, 3}, {0, 3}}) {
      Scene scene{labels(), steps_at(values, 0.4), {}};
      scene.rendering.mode = mode;
      for (ControlPoint& p : scene.tf.points)
        if (p.opacity == 0.4) p.surface.mode = SurfaceMode::on;
      const ImageError error = error_of(scene, whole_volume_camera(scene.volume->grid, 1), {48, 48});
      const std::string what =
          fmt::format("{}, {} steps from {}", name_of(mode), values.size(), *values.begin());
      EXPECT_GT(error.compared.pixels + error.grazing.pixels, 40) << what;
      EXPECT_EQ(error.compared.share, 0) << what;
      EXPECT_EQ(error.grazing.share, 0) << what << ": " << error.grazing.pixels;
      EXPECT_EQ(error.crossings->missed + error.crossings->invented, 0) << what;
    }
}

// Points far beyond the volume's range cost no digits within it, and those that are too near or too far for
// 32-bit float do no harm.
TEST_F(Analytic, PointsFarAwayAndVeryNear) {
  for (const double low : {-1e6, -1e300})
    for (const double gap : {0.0, 1e-300, 1e-9}) {
      Scene scene{labels(),
                  make_tf({point(low, 0), point(1, 0.1, {1, 0, 0}), point(1 + gap, 0.5, {0, 1, 0}),
                           point(1e300, 0.5)}),
                  {}};
      scene.tf.points[2].surface = {SurfaceMode::on, 0.5};
      for (const Mode mode : {Mode::dvr_only, Mode::both}) {
        scene.rendering.mode = mode;
        const ImageError error = error_of(scene, whole_volume_camera(scene.volume->grid, 1), {48, 48});
        EXPECT_EQ(error.compared.share, 0) << low << " " << gap << " " << name_of(mode) << error.compared.max;
        EXPECT_EQ(error.grazing.share, 0) << low << " " << gap << " " << name_of(mode);
        EXPECT_EQ(error.crossings->missed + error.crossings->invented, 0);
      }
    }
}

// Passes join where a span is cut within a cell, and behind what is opaque the light is that of the front.
TEST_F(Analytic, PassesJoin) {
  Scene scene{labels(), steps_at({1, 2, 3}, 0.4), {}};
  scene.rendering.mode = Mode::both;
  scene.rendering.classification = ClassificationMethod::analytic;
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  const Image whole = render(scene, camera, {48, 48});
  raycaster.force({.features = {}, .intervals_per_pass = 3});
  EXPECT_LT(largest_difference(whole, render(scene, camera, {48, 48})), 1e-3);
}

// Surfaces that lie exactly where passes meet are crossed once.
TEST_F(Analytic, SurfacesWherePassesMeet) {
  Grid grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return p.x; });
  Scene scene{volume, make_tf({}), {}};
  for (int value = 1; value < 8; ++value)
    for (const double opacity : {0.0, 0.2, 0.0}) scene.tf.points.push_back(point(value, opacity));
  scene.rendering.mode = Mode::peak_only;
  scene.rendering.classification = ClassificationMethod::analytic;
  raycaster.force({.features = {}, .intervals_per_pass = 1});
  for (const double side : {-1.0, 1.0}) {
    Camera camera = whole_volume_camera(grid, 1);
    camera.target = glm::dvec3(4);
    camera.eye = camera.target + glm::dvec3(side * 16, 0, 0);
    camera.up = {0, 0, 1};
    EXPECT_EQ(draw(scene, camera, {1, 1}).crossings.front(), 7) << side;
  }
}

// Thick materials with colours that change: light comes from their front.
TEST_F(Analytic, ThickColouredMaterials) {
  for (const double unit : {1.0, 1e-1, 1e-3, 1e-5}) {
    Grid grid{glm::ivec3(8), glm::dvec3(1), glm::dvec3(0)};
    const auto volume = make_volume(grid, [](glm::dvec3 p) { return (p.x + 0.3 * p.y + 0.5 * p.z) / 7; });
    Scene scene{volume, make_tf({point(0, 0.6, {1, 0, 0}), point(1.8, 0.6, {0, 1, 0.5})}, unit), {}};
    scene.rendering.mode = Mode::dvr_only;
    const ImageError error = error_of(scene, whole_volume_camera(grid, 1), {32, 32});
    EXPECT_EQ(error.compared.share, 0) << unit << ": " << error.compared.max;
  }
}

// A spike is as exact when it is 1e-7 of the range wide as when it is 1e-1 (its depth is kept the same), also
// at a large offset.
TEST_F(Analytic, SpikesOfAnyWidth) {
  for (const double offset : {0.0, 1e4})
    for (const double width : {1e-1, 1e-3, 1e-5, 1e-7}) {
      Grid grid{glm::ivec3(12), glm::dvec3(1), glm::dvec3(0)};
      const auto volume = make_volume(grid, [=](glm::dvec3 p) {
        return offset + 0.5 + 0.05 * std::sin(0.7 * p.x) * std::cos(0.5 * p.y) + 0.04 * p.z;
      });
      const double at = offset + 0.7;
      Scene scene{volume,
                  make_tf({point(at - width, 0), point(at, 0.95, {1, 0, 0}), point(at + width, 0, {0, 1, 0})},
                          width * 20),
                  {}};
      scene.rendering.mode = Mode::dvr_only;
      const ImageError error = error_of(scene, whole_volume_camera(grid, 1), {48, 48});
      EXPECT_GT(error.compared.pixels, 200) << width;
      EXPECT_EQ(error.compared.share, 0) << width << " " << offset << ": " << error.compared.max;
    }
}

// No crossing is missed and none invented, but where a ray passes a surface's tangent within the rounding of
// 32-bit float. CREST_RAYS=448 takes a million rays.
TEST_F(Analytic, FindsEveryCrossing) {
  const char* asked = std::getenv("CREST_RAYS");
  const int side = asked ? std::atoi(asked) : 64;
  double rays = 0, grazing = 0, off = 0, crossings = 0, wrong = 0;
  for (const auto& [volume, preset] : {std::pair("plume?n=96", "dirac-shell"),
                                       {"gyroid?n=96", "four-peaks"},
                                       {"marschner-lobb?n=96", "four-peaks"},
                                       {"noise?n=64", "noisy-band"},
                                       {"vessels?n=128", "vessels-shell"}}) {
    Scene scene = make_scene(std::make_shared<const Volume>(make_builtin(volume)), load_preset(preset));
    scene.rendering.mode = Mode::peak_only;
    scene.rendering.shading = Shading::none;
    const ImageError error = error_of(scene, whole_volume_camera(scene.volume->grid, 1), glm::ivec2(side));
    EXPECT_EQ(error.crossings->missed, 0) << volume;
    EXPECT_EQ(error.crossings->invented, 0) << volume;
    rays += double(side) * side;
    grazing += double(error.grazing.pixels);
    off += error.grazing.share * double(error.grazing.pixels);
    crossings += error.crossings->exact;
    wrong += error.compared.share * double(error.compared.pixels);
  }
  EXPECT_EQ(wrong, 0);
  fmt::print("{} rays, {} crossings; {} rays graze a surface, {:.0f} of them off by more than 1/255\n", rays,
             crossings, grazing, off);
}

}  // namespace
}  // namespace crest::testing
