#include "render/slices/slice_renderer.h"

#include "render/volume/probe.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

class Slices : public RaycasterTest {
 protected:
  std::vector<glm::dvec3> draw(const Scene& scene, const Slice& slice, glm::ivec2 size) {
    gl::DisplayTexture display(size);
    SliceRenderer().draw(resources, scene, slice, display);
    std::vector<std::uint8_t> bytes(std::size_t(4 * size.x * size.y));
    glGetTextureImage(display.texture(), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(bytes.size()), bytes.data());
    std::vector<glm::dvec3> pixels;
    for (std::size_t i = 0; i < bytes.size(); i += 4)
      pixels.push_back(glm::dvec3(bytes[i], bytes[i + 1], bytes[i + 2]) / 255.0);
    return pixels;
  }
  Resources resources;
};

double largest(glm::dvec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

std::shared_ptr<const Volume> noise() {
  static const auto volume = make_volume({{7, 9, 6}, {1, 0.5, 2}, {3, -2, 10}}, [](glm::dvec3 p) {
    return std::sin(1.3 * p.x) + std::cos(1.7 * p.y) * std::sin(0.4 * p.z + p.x);
  });
  return volume;
}

TEST_F(Slices, HaveTheTransferFunctionsColours) {
  Scene scene{
      noise(), make_tf({point(-2, 0, {1, 0, 0}), point(-0.5, 0.2, {0, 1, 0}), point(2, 0.9, {0, 0, 1})}), {}};
  constexpr glm::ivec2 size{24, 20};
  for (const Filter filter : {Filter::linear, Filter::bspline, Filter::bc})
    for (int axis = 0; axis < 3; ++axis) {
      scene.rendering.filter = filter;
      const Slice slice{axis, 0.37};
      const std::vector<glm::dvec3> pixels = draw(scene, slice, size);
      const ValueRange range = scene.volume->statistics.range;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const glm::dvec3 place = place_in_box(slice, {(x + 0.5) / size.x, (y + 0.5) / size.y});
          const double value = *value_at(*scene.volume, dvr_filter(scene.rendering), place);
          const Classified at = evaluate(scene.tf, value);
          const glm::dvec3 grey(0.7 * std::clamp((value - range.min) / range.width(), 0.0, 1.0));
          const glm::dvec3 expected = glm::mix(grey, at.color, std::cbrt(at.opacity));
          ASSERT_LT(largest(pixels[std::size_t(y * size.x + x)] - expected), 1.5 / 255) << x << ' ' << y;
        }
    }
}

// On a plane of values a surface is a straight line: pixels within 1.25 of it have some of its colour, and
// within 0.75 - 0.5 all of it.
TEST_F(Slices, LinesAreWhereSurfacesMeetThem) {
  const auto volume =
      make_volume({{9, 9, 3}, glm::dvec3(1), glm::dvec3(0)}, [](glm::dvec3 p) { return 2 * p.x + p.y; });
  Scene scene{volume,
              make_tf({point(0, 0), point(9.99, 0), point(10, 0.5, {1, 0, 0}), point(10.01, 0),
                       point(16.99, 0), point(17, 0.5, {0, 1, 0}), point(17.01, 0), point(24, 0)}),
              {}};
  constexpr glm::ivec2 size{80, 80};
  const std::vector<glm::dvec3> pixels = draw(scene, {2, 0.5}, size);
  int reds = 0, greens = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::dvec3 place = place_in_box({2, 0.5}, {(x + 0.5) / size.x, (y + 0.5) / size.y}) * 8.0;
      const auto pixels_to = [&](double value) {
        return std::abs(2 * place.x + place.y - value) / std::sqrt(5.0) * 10;
      };
      const glm::dvec3 color = pixels[std::size_t(y * size.x + x)];
      const double red = color.r - std::max(color.g, color.b), green = color.g - std::max(color.r, color.b);
      const auto share = [](double distance) { return std::clamp(1.25 - distance, 0.0, 1.0); };
      EXPECT_NEAR(std::max(red, 0.0), share(pixels_to(10)), 0.02) << x << ' ' << y;
      EXPECT_NEAR(std::max(green, 0.0), share(pixels_to(17)), 0.02) << x << ' ' << y;
      reds += red > 0.5;
      greens += green > 0.5;
    }
  EXPECT_GT(reds, 80);
  EXPECT_GT(greens, 80);
}

TEST_F(Slices, EmptyCellsAreBlack) {
  Volume holed = *noise();
  holed.values.floats()[0] = NAN;
  holed.statistics = compute_statistics(holed.grid, holed.values);
  const Scene scene{std::make_shared<const Volume>(holed), make_tf({point(-2, 1), point(2, 1)}), {}};
  const std::vector<glm::dvec3> pixels = draw(scene, {2, 0.1}, {12, 16});  // two a cell
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const bool is_corner = i / 12 >= 14 && i % 12 < 2;  // the first points are at the bottom left
    EXPECT_EQ(pixels[i], glm::dvec3(is_corner ? 0 : 1)) << i;
  }
}

TEST(Slice, PlacesAreRightSideUp) {
  EXPECT_EQ(place_in_box({2, 0.25}, {0.125, 0}), glm::dvec3(0.125, 1, 0.25));
  EXPECT_EQ(place_in_box({1, 0.25}, {0.125, 1}), glm::dvec3(0.125, 0.25, 0));
  EXPECT_EQ(place_in_box({0, 0.25}, {0.125, 0.5}), glm::dvec3(0.25, 0.125, 0.5));
}

}  // namespace
}  // namespace crest::testing
