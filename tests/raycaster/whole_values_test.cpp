#include "render/volume/whole_values.h"

#include <cmath>
#include <limits>

#include "presets/names.h"
#include "render/renderer.h"
#include "render/resources/texel_format.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

using Ptr = std::shared_ptr<const Volume>;

/// A gyroid in `levels` steps, as the integers `map` makes values of.
template <class Integer>
Ptr stored_gyroid(int levels, int least, LinearMap map) {
  Volume volume = make_builtin("gyroid?n=24");
  const ValueRange range = volume.statistics.range;
  std::vector<Integer> stored;
  for (const float value : volume.values.to_floats())
    stored.push_back(Integer(least + std::lround((double(value) - range.min) / range.width() * levels)));
  volume.values = Voxels(std::move(stored), map);
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

Ptr as_floats(const Ptr& volume) {
  Volume floats = *volume;
  floats.values.floats();
  return std::make_shared<const Volume>(std::move(floats));
}

/// Haze, a spike, and a step at a value that voxels have.
Scene scene_of(const Ptr& volume, double level) {
  const ValueRange range = volume->statistics.range;
  const auto at = [&](double share) { return range.min + share * range.width(); };
  const double narrow = 1e-3 * range.width();
  Scene scene;
  scene.volume = volume;
  scene.tf = make_tf({point(at(0), 0), point(at(0.2), 0.02, {0.2, 0.4, 1}), point(at(0.3) - narrow, 0.02),
                      point(at(0.3), 0.9, {1, 0.2, 0.1}), point(at(0.3) + narrow, 0.02), point(level, 0.02),
                      point(level, 0.3, {1, 0.9, 0.3}), point(at(1), 0.3, {0.2, 0.8, 0.3})},
                     0.2);
  scene.rendering.step = 0.5;
  return scene;
}

TEST(WholeValues, AreFoundWhereNoValueIsRounded) {
  const Ptr ct = stored_gyroid<std::int16_t>(4095, -2000, {1, 976});
  const auto whole = whole_values(*ct);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->base, -1024);
  EXPECT_EQ(whole->step, 1);
  EXPECT_EQ(whole->most, 4095);
  EXPECT_TRUE(whole_values(*stored_gyroid<std::uint8_t>(255, 0, {-0.25, 3})));
  EXPECT_FALSE(whole_values(*stored_gyroid<std::uint8_t>(255, 0, {0.1, 0})));
  EXPECT_FALSE(whole_values(*stored_gyroid<std::uint8_t>(255, 0, {1, 0.5})));
  EXPECT_FALSE(whole_values(*stored_gyroid<std::uint16_t>(60000, 0, {1, 1e9})));
  EXPECT_FALSE(whole_values(*stored_gyroid<std::uint8_t>(255, 0, {0, 3})));
  EXPECT_FALSE(whole_values(*as_floats(ct)));
}

// As of a time step, whose range is that of all.
TEST(WholeValues, LieOnTheirStepsInAnyRange) {
  Volume volume = *stored_gyroid<std::int16_t>(400, 100, {0.5, 3});
  const double least = volume.statistics.range.min;
  widen_range(volume, {least - 10.3, least + 1000});
  const auto whole = whole_values(volume);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->base, least - 10.5);
  std::vector<std::uint16_t> steps(volume.values.size());
  write_steps(volume, *whole, 0, 1, steps);
  for (std::size_t i = 0; i < steps.size(); ++i)
    ASSERT_EQ(float(whole->base + whole->step * steps[i]), volume.values[i]) << i;
  widen_range(volume, {least - 40000, least});
  EXPECT_FALSE(whole_values(volume)) << "more steps than 16 bits hold";
}

TEST(WholeValues, AreWrittenAsStepsFromTheLeastOne) {
  for (const double slope : {1.0, -0.5}) {
    const Ptr volume = stored_gyroid<std::int8_t>(200, -100, {slope, 7});
    const WholeValues whole = *whole_values(*volume);
    std::vector<std::uint16_t> steps(volume->values.size());
    write_steps(*volume, whole, 0, 1, steps);
    for (std::size_t i = 0; i < steps.size(); ++i)
      ASSERT_EQ(float(whole.base + whole.step * steps[i]), volume->values[i]);
  }
}

// A share of 16 bits times the greatest one is rounded to the number it was made of, whatever the spread.
TEST(WholeValues, ComeBackFromSharesOfSixteenBits) {
  for (int spread = 1; spread <= 128; spread *= 2)
    for (int step = 0; step * spread <= 65535; ++step) {
      const float share = float(step * spread) / 65535.0F, value = share * (65535.0F / float(spread));
      ASSERT_EQ(std::round(value), float(step));
      ASSERT_LE(std::abs(value - float(step)), 2.5e-7F * float(step));
    }
}

class WholeValuesDrawn : public RaycasterTest {};

TEST_F(WholeValuesDrawn, TakeTwoBytesAPoint) {
  const Ptr volume = stored_gyroid<std::uint8_t>(255, 0, {});
  KeyedCache held(0);
  EXPECT_EQ(texel_format(held, *volume).internal, GLenum(GL_R16));
  EXPECT_EQ(texel_kind(held, *volume).bytes, 2u);
  EXPECT_EQ(texel_format(held, *as_floats(volume)).internal, GLenum(GL_R32F));
  EXPECT_EQ(texel_kind(held, *as_floats(volume)).bytes, 4u);
}

// What is fetched and interpolated in float is the same number; the texture unit's may round otherwise.
TEST_F(WholeValuesDrawn, MakeThePictureThatFloatsMake) {
  constexpr glm::ivec2 size{48, 48};
  Renderer renderer;
  const auto draw = [&](Scene scene) {
    gl::RenderTarget target(size, false);
    renderer.draw(scene, sees_unit_cube, target);
    return target.read_color();
  };
  for (const Ptr& volume : {stored_gyroid<std::uint8_t>(5, 0, {}), stored_gyroid<std::uint8_t>(255, 0, {}),
                            stored_gyroid<std::int16_t>(4095, -2048, {1, 0}),
                            stored_gyroid<std::uint16_t>(65535, 0, {0.5, -100})}) {
    const double level = double(volume->values[volume->index(12, 12, 12)]);
    const Ptr floats = as_floats(volume);
    const auto compare = [&](const std::string& what, double bound, const auto& change) {
      Scene scene = scene_of(volume, level);
      change(scene.rendering);
      const Image whole = draw(scene);
      scene.volume = floats;
      const Image wide = draw(scene);
      EXPECT_LE(largest_difference(whole, wide), bound) << what << " " << volume->statistics.range.max;
      EXPECT_GT(largest_difference(whole, Image{size, std::vector<glm::vec4>(whole.pixels.size())}), 0.1);
    };
    for (const auto& [filter, name] : names_of<Filter>())
      compare(std::string(name), 1e-4, [&](Rendering& r) { r.filter = filter; });
    compare("peaks", 1e-4, [](Rendering& r) { r.mode = Mode::peak_xor_dvr; });
    compare("shaded", 1e-4, [](Rendering& r) { r.shading = Shading::gradient; });
    compare("preintegrated", 1e-4,
            [](Rendering& r) { r.classification = ClassificationMethod::preintegrated; });
    compare("analytic", 1e-5, [](Rendering& r) { r.classification = ClassificationMethod::analytic; });
    compare("vdls", 1e-4, [](Rendering& r) {
      r.engine = Engine::vdls;
      r.mode = Mode::dvr_only;
    });
  }
}

}  // namespace
}  // namespace crest::testing
