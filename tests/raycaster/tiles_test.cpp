// A picture that is drawn in tiles, so that no draw takes long, is the one that is drawn at once.
#include "render/measure/tiles.h"

#include "presets/preset_file.h"
#include "render/renderer.h"
#include "render/volume/builtin.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

using Tiles = RaycasterTest;

TEST(TileRows, FollowWhatTheLastOnesTook) {
  EXPECT_EQ(next_tile_rows(10, 50, 100), 20);
  EXPECT_EQ(next_tile_rows(10, 80, 100), 12);
  EXPECT_EQ(next_tile_rows(10, 1000, 100), 1);
  EXPECT_EQ(next_tile_rows(10, 1e9, 100), 1);
  EXPECT_EQ(next_tile_rows(10, 0, 100), 20) << "at most twice as many: the next rows may cost more";
}

TEST_F(Tiles, CoverThePictureOnce) {
  for (const double tile_ms : {1e-9, 1e9}) {
    double ms_per_row = 0;
    int row = 0, tiles = 0;
    draw_in_tiles(
        {7, 100}, ms_per_row,
        [&](Tile tile) {
          EXPECT_EQ(tile.begin, glm::ivec2(0, row));
          EXPECT_EQ(tile.end.x, 7);
          row = tile.end.y;
          ++tiles;
        },
        tile_ms);
    EXPECT_EQ(row, 100);
    EXPECT_GT(tiles, 5) << "nothing was known of the picture";
    tiles = 0;
    draw_in_tiles(
        {7, 100}, ms_per_row, [&](Tile) { ++tiles; }, tile_ms);
    EXPECT_EQ(tiles, tile_ms < 1 ? 100 : 1);
  }
}

TEST_F(Tiles, LeaveThePictureAsItIs) {
  const auto volume = std::make_shared<const Volume>(make_builtin("gyroid?n=20"));
  const Camera camera = whole_volume_camera(volume->grid, 1);
  const glm::ivec2 size(37, 41);
  Renderer renderer;
  const auto expect_same = [&](const Scene& scene) {
    gl::RenderTarget whole(size, false), tiled(size, false);
    renderer.draw(scene, camera, whole);
    for (const double tile_ms : {1e-9, 1e9}) {
      double ms_per_row = 0;
      draw_in_tiles(
          size, ms_per_row, [&](Tile tile) { renderer.draw(scene, camera, tiled, tile); }, tile_ms);
      EXPECT_EQ(tiled.read_color().pixels, whole.read_color().pixels);
    }
    const Image picture = whole.read_color();
    EXPECT_GT(std::ranges::max(picture.pixels, {}, [](const glm::vec4& p) { return p.a; }).a, 0.05f);
  };
  Scene scene = make_scene(volume, load_preset("four-peaks"));
  scene.rendering.shading = Shading::gradient;
  expect_same(scene);
  Forced passes;
  passes.features.long_rays = true;
  passes.intervals_per_pass = 11;
  renderer.raycaster().force(passes);
  expect_same(scene);
  renderer.raycaster().force({});
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.engine = Engine::vdls;
  expect_same(scene);
}

}  // namespace
}  // namespace crest::testing
