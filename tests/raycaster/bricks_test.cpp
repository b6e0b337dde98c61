#include "render/volume/bricks.h"

#include <glm/gtx/component_wise.hpp>
#include <random>

#include "presets/names.h"
#include "render/raycaster/trace_ray.h"
#include "render/resources/brick_atlas.h"
#include "render/resources/macrocell_texture.h"
#include "render/resources/volume_texture.h"
#include "render/slices/slice_renderer.h"
#include "render/volume/builtin.h"
#include "render/volume/macrocells.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

using Ptr = std::shared_ptr<const Volume>;
constexpr glm::ivec2 size{64, 64};

TEST(Bricks, HaveEachCellOnce) {
  EXPECT_EQ(brick_dims({{33, 34, 2}}), glm::ivec3(1, 2, 1));
  EXPECT_EQ(brick_dims({{65, 64, 96}}), glm::ivec3(2, 2, 3));
}

TEST(Bricks, ThatHoldABoxAreThoseOfItsCells) {
  const Grid grid{{97, 97, 97}};
  BrickSet set(brick_count(grid));
  add_bricks(set, grid, {31, 0, 70}, {32, 5, 500});
  EXPECT_EQ(size_of(set), 2u);
  EXPECT_TRUE(set[0 + 3 * (0 + 3 * 2)]);
  EXPECT_TRUE(set[1 + 3 * (0 + 3 * 2)]);
  add_bricks(set, grid, {-9, -9, -9}, {200, 200, 200});
  EXPECT_EQ(size_of(set), 27u);
}

TEST(Bricks, AroundMacrocellsAreThoseOfTheirBoxes) {
  std::mt19937 random(1);
  std::size_t some = 0;
  for (int i = 0; i < 200; ++i) {
    const auto in = [&](int least, int most) { return std::uniform_int_distribution(least, most)(random); };
    const Grid grid{{in(2, 200), in(2, 200), in(2, 200)}};
    const int side = in(2, 17), reach = in(0, 10) == 0 ? 300 : in(0, 80), one_in = in(1, 2000);
    const glm::ivec3 dims = macrocell_dims(grid, side);
    std::vector<std::uint8_t> marks;
    BrickSet expected(brick_count(grid));
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) {
          marks.push_back(in(1, one_in) == 1);
          const glm::ivec3 first = side * glm::ivec3(x, y, z);
          if (marks.back()) add_bricks(expected, grid, first - reach, first + side + reach);
        }
    ASSERT_EQ(bricks_around(marks, grid, side, reach), expected) << i;
    if (size_of(expected) > 0 && size_of(expected) < brick_count(grid)) ++some;
  }
  EXPECT_GT(some, 50U);
}

// Zooming in and out changes the longest step all the time; what is held stays the same for many.
TEST(Bricks, StayWhileTheLongestStepChangesLittle) {
  const Volume volume = make_builtin("vessels?n=100");
  Scene scene;
  scene.volume = std::make_shared<const Volume>(volume);
  scene.tf = make_tf({point(0.4, 0), point(0.5, 0.5)});
  const Classification classification = classify(scene.tf, volume.statistics.range);
  Features features;
  features.dvr = features.skipping = true;
  KeyedCache held(std::size_t(1) << 20);
  std::vector<const BrickSet*> sets;
  for (double step = 1; step < 20; step += 0.25) {
    const auto& set = shown_bricks(held, {scene, classification, features, {}}, step);
    if (sets.empty() || set.get() != sets.back()) sets.push_back(set.get());
  }
  EXPECT_EQ(sets.size(), 3U);
}

/// Thin tubes in empty space, on a grid that bricks do not divide evenly, as 8 bits or as floats.
Ptr vessels(bool as_floats) {
  const Volume cube = make_builtin("vessels?n=100");
  Volume volume;
  volume.name = cube.name;
  volume.grid = {{100, 90, 71}, cube.grid.spacing, cube.grid.origin};
  std::vector<std::uint8_t> stored;
  for (int k = 0; k < 71; ++k)
    for (int j = 0; j < 90; ++j)
      for (int i = 0; i < 100; ++i)
        stored.push_back(std::uint8_t(std::lround(255 * std::clamp(double(cube.at(i, j, k)), 0.0, 1.0))));
  volume.values = Voxels(std::move(stored), {});
  if (as_floats) volume.values.floats();
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

Scene scene_of(const Ptr& volume) {
  Scene scene;
  scene.volume = volume;
  scene.tf = make_tf({point(0, 0), point(60, 0), point(90, 0.3, {1, 0.3, 0.2}), point(119, 0.05),
                      point(120, 0.9, {1, 1, 0.6}), point(121, 0.05), point(255, 0.5, {0.3, 0.6, 1})},
                     0.02);
  scene.rendering.step = 0.5;
  return scene;
}

class BricksDrawn : public RaycasterTest {
 protected:
  BricksDrawn() { bricked->whole_volume_bytes = 1000; }

  static Image drawn(Raycaster& with, const Scene& scene) {
    gl::RenderTarget target(size, false);
    with.draw(scene, sees_unit_cube, target);
    return target.read_color();
  }
  std::shared_ptr<Resources> bricked = std::make_shared<Resources>();
  Raycaster in_bricks{bricked};
};

TEST_F(BricksDrawn, MakeThePictureOfTheWholeVolume) {
  for (const bool as_floats : {false, true}) {
    const Ptr volume = vessels(as_floats);
    const auto compare = [&](const std::string& what, double bound, const auto& change) {
      Scene scene = scene_of(volume);
      change(scene.rendering);
      const Need need = in_bricks.need(scene, sees_unit_cube, size, false);
      EXPECT_TRUE(need.features.bricks);
      EXPECT_TRUE(need.features.skipping);
      EXPECT_LT(need.brick_count, brick_count(volume->grid)) << what;
      const Image parts = drawn(in_bricks, scene), whole = drawn(raycaster, scene);
      EXPECT_LE(largest_difference(parts, whole), bound) << what;
      EXPECT_GT(largest_difference(whole, Image{size, std::vector<glm::vec4>(whole.pixels.size())}), 0.1);
    };
    const double filtered = 1e-3, fetched = 1e-6;  // the texture unit takes places in another texture
    compare("linear", filtered, [](Rendering&) {});
    compare("analytic", fetched, [](Rendering& r) { r.classification = ClassificationMethod::analytic; });
    if (as_floats) continue;
    compare("linear_exact", fetched, [](Rendering& r) { r.filter = Filter::linear_exact; });
    compare("bspline", filtered, [](Rendering& r) { r.filter = Filter::bspline; });
    compare("bc", fetched, [](Rendering& r) { r.filter = Filter::bc; });
    compare("xor", filtered, [](Rendering& r) { r.mode = Mode::peak_xor_dvr; });
    compare("dvr", filtered, [](Rendering& r) { r.mode = Mode::dvr_only; });
    compare("shaded", filtered, [](Rendering& r) { r.shading = Shading::gradient; });
    compare("long steps", filtered, [](Rendering& r) { r.step = 4; });
    compare("adaptive", filtered, [](Rendering& r) { r.adaptive = true; });
    compare("preintegrated", filtered,
            [](Rendering& r) { r.classification = ClassificationMethod::preintegrated; });
  }
}

/// What shows ends at x = 20. The next brick, from x = 32 on, shows nothing, and its first point is unlike
/// the others.
Ptr wall() {
  Volume volume;
  volume.name = "wall";
  volume.grid = {{97, 34, 34}};
  std::vector<std::uint8_t> stored;
  for (std::size_t i = 0; i < volume.grid.point_count(); ++i) {
    const std::size_t x = i % 97;
    stored.push_back(x <= 20 ? 100 : x == 32 ? 0 : 59);
  }
  volume.values = Voxels(std::move(stored), {});
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

// A segment ends at a sample that lies as far beyond what shows as the longest step, whatever `step` is.
TEST_F(BricksDrawn, ReachAsFarAsStepsThatGrow) {
  Scene scene = scene_of(wall());
  scene.tf = make_tf({point(0, 0), point(60, 0), point(100, 0.02), point(255, 0.02)}, 1);
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.classification = ClassificationMethod::preintegrated;
  scene.rendering.placement = Placement::entry;
  scene.rendering.sampling = Sampling::differential;
  scene.rendering.step = 0.1;
  const Camera along_x{{-100, 16, 16}, {48, 16, 16}, {0, 0, 1}, 30, Projection::parallel, {}};
  const auto draw = [&](Raycaster& with) {
    gl::RenderTarget target(size, false);
    with.draw(scene, along_x, target);
    return target.read_color();
  };
  for (const double s_k : {8, 9, 10, 11, 12}) {
    scene.rendering.s_k = s_k;
    const Need need = in_bricks.need(scene, along_x, size, false);
    EXPECT_TRUE(need.features.bricks);
    EXPECT_GT(need.longest_step, 12);
    EXPECT_LE(largest_difference(draw(in_bricks), draw(raycaster)), 1e-3) << s_k;
  }
}

/// How many surfaces the rays through some pixels cross.
std::size_t expect_same_rays(Raycaster& in_bricks, Raycaster& in_whole, const Scene& scene,
                             const Camera& camera) {
  std::size_t crossings = 0;
  for (int y = 4; y < size.y; y += 8)
    for (int x = 4; x < size.x; x += 8) {
      const auto parts = trace_ray(in_bricks, scene, camera, size, {x, y}),
                 whole = trace_ray(in_whole, scene, camera, size, {x, y});
      EXPECT_EQ(parts.size(), whole.size());
      for (std::size_t i = 0; i < std::min(parts.size(), whole.size()); ++i) {
        EXPECT_EQ(parts[i].depth, whole[i].depth);
        EXPECT_EQ(parts[i].crossings, whole[i].crossings) << x << ' ' << y << ' ' << i;
        EXPECT_LE(glm::compMax(glm::abs(parts[i].color - whole[i].color)), 1e-3) << x << ' ' << y << ' ' << i;
      }
      if (!whole.empty()) crossings += std::size_t(whole.back().crossings);
    }
  return crossings;
}

TEST_F(BricksDrawn, ARayIsTracedAsInTheWholeVolume) {
  const Scene scene = scene_of(vessels(false));
  EXPECT_GT(expect_same_rays(in_bricks, raycaster, scene, sees_unit_cube), 0U);
  EXPECT_LT(in_bricks.need(scene, sees_unit_cube, size, false).brick_count, brick_count(scene.volume->grid));
}

// Where values count that show nothing, no brick is left out, and none may be traced as if it were.
TEST_F(BricksDrawn, ARayIsTracedAsInTheWholeVolumeInEachBlendMode) {
  Scene scene = scene_of(wall());
  scene.tf = make_tf({point(0, 0), point(60, 0), point(61, 0.5), point(255, 0.9)}, 1);
  scene.rendering.mode = Mode::dvr_only;
  const Camera along_x{{-100, 16, 16}, {48, 16, 16}, {0, 0, 1}, 30, Projection::parallel, {}};
  std::size_t without_a_brick = 0;
  for (const auto& [mode, name] : EnumNames<BlendMode>::table) {
    SCOPED_TRACE(name);
    scene.rendering.blend_mode = mode;
    expect_same_rays(in_bricks, raycaster, scene, along_x);
    const Need need = in_bricks.need(scene, along_x, size, false);
    if (need.brick_count < brick_count(scene.volume->grid)) ++without_a_brick;
  }
  EXPECT_GT(without_a_brick, 0U);
}

TEST_F(BricksDrawn, AreAllHeldWhereNothingIsSkipped) {
  const Ptr volume = vessels(false);
  Scene scene = scene_of(volume);
  scene.rendering.skipping = false;
  EXPECT_EQ(in_bricks.need(scene, sees_unit_cube, size, false).brick_count, brick_count(volume->grid));
  EXPECT_LE(largest_difference(drawn(in_bricks, scene), drawn(raycaster, scene)), 1e-3);
}

std::vector<std::uint8_t> slice_of(Resources& resources, const Scene& scene, const Slice& slice) {
  gl::DisplayTexture display(size);
  SliceRenderer().draw(resources, scene, slice, display);
  std::vector<std::uint8_t> bytes(std::size_t(4 * size.x * size.y));
  glGetTextureImage(display.texture(), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(bytes.size()), bytes.data());
  return bytes;
}

TEST_F(BricksDrawn, SlicesAreThoseOfTheWholeVolume) {
  const Scene scene = scene_of(vessels(false));
  for (const double place : {0.0, 0.31, 0.5, 1.0})
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(slice_of(*bricked, scene, {axis, place}),
                slice_of(raycaster.resources(), scene, {axis, place}))
          << axis << ' ' << place;
}

TEST_F(BricksDrawn, StayWhileThereIsRoom) {
  const Ptr volume = vessels(false);
  KeyedCache held(0);
  BrickAtlas atlas(*volume, texel_format(held, *volume));
  const auto some = [&](std::size_t first, std::size_t count) {
    auto set = std::make_shared<BrickSet>(brick_count(volume->grid));
    std::fill_n(set->begin() + std::ptrdiff_t(first), count, std::uint8_t(1));
    return std::shared_ptr<const BrickSet>(set);
  };
  constexpr std::size_t plenty = std::size_t(1) << 30;
  atlas.require(some(0, 20), plenty);
  EXPECT_EQ(atlas.uploads(), 20);
  atlas.require(some(5, 15), plenty);
  EXPECT_EQ(atlas.uploads(), 20);
  atlas.require(some(0, 22), plenty);  // into the quarter that is kept
  EXPECT_EQ(atlas.uploads(), 22);
  const auto first = some(0, 22), second = some(20, 10);
  atlas.require(second, plenty);  // in a new texture, with room for both
  EXPECT_EQ(atlas.uploads(), 32);
  atlas.require(first, plenty);
  EXPECT_EQ(atlas.uploads(), 52);
  for (int i = 0; i < 3; ++i) atlas.require(i % 2 ? first : second, plenty);
  EXPECT_EQ(atlas.uploads(), 52);
  EXPECT_THROW(BrickAtlas(*volume, texel_format(held, *volume)).require(first, 1000), gl::NoRoom);
}

}  // namespace
}  // namespace crest::testing
