#include "render/gl/filter_weights.h"

#include <algorithm>

#include "render/raycaster/sharpness.h"
#include "render/volume/builtin.h"
#include "tests/changed_shaders.h"
#include "tests/raycaster/fixture.h"

// Texture units whose weights have 8 bits, and what becomes of the filter there. llvmpipe has none: they are
// emulated.
namespace crest::testing {
namespace {

constexpr glm::ivec2 size{96, 96};
constexpr double eight_bits = 0x1p-9;

ChangedShaders coarse_texture_unit() {
  return {"filter_linear.glsl",
          "float linear_field(vec3 position) { return value_between(position * texture_scale + "
          "texture_offset); }",
          "float linear_field(vec3 position) {\n"
          "  vec3 points = vec3(textureSize(volume, 0));\n"
          "  vec3 place = (position * texture_scale + texture_offset) * points - 0.5, low = floor(place);\n"
          "  vec3 weight = round((place - low) * 256.0) / 256.0;\n"
          "  return value_between((low + weight + 0.5) / points);\n"
          "}"};
}

class FilterWeights : public RaycasterTest {
 protected:
  /// A rise of opacity `width` wide, in shares of the volume's range.
  static Scene rising(double width) {
    Scene scene;
    scene.volume = std::make_shared<const Volume>(make_builtin("marschner-lobb?n=24"));
    const ValueRange range = scene.volume->statistics.range;
    const double middle = range.min + 0.5 * range.width(), half = 0.5 * width * range.width();
    scene.tf = make_tf({point(middle - half, 0), point(middle + half, 0.6, {1, 0.4, 0.2})}, 0.1);
    scene.rendering.mode = Mode::dvr_only;
    return scene;
  }
  static Image drawn(Raycaster& with, Scene scene, std::optional<Filter> filter = {}) {
    if (filter) scene.rendering.filter = *filter;
    gl::RenderTarget target(size, false);
    with.draw(scene, sees_unit_cube, target);
    return target.read_color();
  }
  static Need need_of(Raycaster& with, const Scene& scene) {
    return with.need(scene, sees_unit_cube, size, false);
  }
  static long pixels_off(const Image& a, const Image& b) {
    long off = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
      off += glm::any(glm::greaterThan(glm::abs(a.pixels[i] - b.pixels[i]), glm::vec4(1.0f / 255)));
    return off;
  }
};

std::string why_left_out(const Need& need, const std::string& name) {
  const auto found = std::ranges::find(need.list.left_out, name, &std::pair<std::string, std::string>::first);
  return found == need.list.left_out.end() ? "" : found->second;
}

TEST_F(FilterWeights, TheDriversOwnAreMeasured) {
  const double error = gl::measure_weight_error();
  EXPECT_LE(error, 1.01 * 0x1p-8);  // GL hardware has 8 bits, some of it truncates them
  if (const std::string name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
      name.find("llvmpipe") != name.npos) {
    EXPECT_EQ(error, 0);
  }
  EXPECT_EQ(gl::weight_bits(eight_bits), 8);
}

TEST_F(FilterWeights, ASharpTfTakesFloat) {
  const Scene sharp = rising(1e-3);
  const ChangedShaders shaders = coarse_texture_unit();
  Raycaster unaware(shaders.folder()), aware(shaders.folder());
  unaware.assume_weight_bits(23);
  aware.assume_weight_bits(8);
  EXPECT_EQ(need_of(unaware, sharp).features.filter, Filter::linear);
  const Need need = need_of(aware, sharp);
  EXPECT_EQ(need.features.filter, Filter::linear_exact);
  EXPECT_EQ(need.features.root_filter, Filter::linear_exact);  // no field is evaluated twice
  EXPECT_NE(why_left_out(need, "filter_linear").find("8 bits"), std::string::npos);

  const Image exact = drawn(raycaster, sharp, Filter::linear_exact);
  EXPECT_GT(pixels_off(drawn(unaware, sharp), exact), 40);
  EXPECT_EQ(largest_difference(drawn(aware, sharp), exact), 0);
}

TEST_F(FilterWeights, ASmoothTfKeepsTheTextureUnit) {
  const Scene smooth = rising(0.9);
  const ChangedShaders shaders = coarse_texture_unit();
  Raycaster aware(shaders.folder());
  aware.assume_weight_bits(8);
  const Need need = need_of(aware, smooth);
  EXPECT_EQ(need.features.filter, Filter::linear);
  EXPECT_EQ(why_left_out(need, "filter_linear"), "");
  EXPECT_EQ(pixels_off(drawn(aware, smooth), drawn(raycaster, smooth, Filter::linear_exact)), 0);
}

// Where something is decided, both sides of it hold what they say.
TEST_F(FilterWeights, NoTfThatKeepsItShowsStairs) {
  const ChangedShaders shaders = coarse_texture_unit();
  Raycaster aware(shaders.folder());
  aware.assume_weight_bits(8);
  int kept = 0, exact = 0;
  for (const double width : {0.5, 0.25, 0.12, 0.06, 0.03, 0.015}) {
    const Scene scene = rising(width);
    if (need_of(aware, scene).features.filter == Filter::linear) {
      ++kept;
      EXPECT_LE(pixels_off(drawn(aware, scene), drawn(raycaster, scene, Filter::linear_exact)), 20) << width;
    } else {
      ++exact;
    }
  }
  EXPECT_GT(kept, 0);
  EXPECT_GT(exact, 0);
}

TEST_F(FilterWeights, NobodyAsksWhereTheyDoNotMatter) {
  Scene scene = rising(1e-3);
  raycaster.assume_weight_bits(8);
  for (const auto change : {+[](Rendering& r) { r.mode = Mode::peak_only; },
                            +[](Rendering& r) { r.classification = ClassificationMethod::analytic; },
                            +[](Rendering& r) { r.filter = Filter::linear_exact; },
                            +[](Rendering& r) { r.filter = Filter::bc; }}) {
    Scene other = scene;
    change(other.rendering);
    EXPECT_EQ(why_left_out(need_of(raycaster, other), "filter_linear"), "");
  }
  scene.rendering.filter = Filter::bspline;
  const Need need = need_of(raycaster, scene);
  EXPECT_EQ(need.features.filter, Filter::bspline);
  EXPECT_EQ(need.list.notes.size(), 1U);
  raycaster.assume_weight_bits(23);
  EXPECT_TRUE(need_of(raycaster, scene).list.notes.empty());
}

TEST(Sharpness, IsWhatASegmentChanges) {
  const TransferFunction step = make_tf({point(0, 0), point(0.5, 0), point(0.5, 0.5), point(1, 0.5)});
  EXPECT_NEAR(largest_change_within(step, {0, 1}, 1e-6, 1), 0.5, 1e-12);
  EXPECT_NEAR(largest_change_within(step, {0, 0.4}, 1e-6, 1), 0, 1e-12);
  EXPECT_NEAR(largest_change_within(step, {0, 1}, 1e-6, 0.5), 1 - std::sqrt(0.5), 1e-12);
  const TransferFunction ramp = make_tf({point(0, 0), point(1, 0.5)});
  EXPECT_NEAR(largest_change_within(ramp, {0, 1}, 0.01, 1), 0.005, 1e-12);
  const TransferFunction spike =
      make_tf({point(0, 0), point(0.5 - 1e-6, 0), point(0.5, 0.9), point(0.5 + 1e-6, 0)});
  EXPECT_NEAR(largest_change_within(spike, {0, 1}, 0.01, 1), 0.9, 1e-12);
  EXPECT_EQ(largest_change_within(make_tf({}), {0, 1}, 0.01, 1), 0);
  const TransferFunction colors = make_tf({point(0, 0.5, {1, 0, 0}), point(1e-9, 0.5, {0, 0, 1})});
  EXPECT_NEAR(largest_change_within(colors, {0, 1}, 0.01, 1), 0.5, 1e-12);
}

}  // namespace
}  // namespace crest::testing
