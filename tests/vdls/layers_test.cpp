#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "presets/error.h"
#include "presets/names.h"
#include "tests/gl_waits.h"
#include "tests/paths.h"
#include "tests/vdls/fixture.h"

namespace crest::testing {
namespace {

using Layers = VdlsTest;

/// All ways of working, each speed-up on and off.
std::vector<VdlsOptions> all_options() {
  std::vector<VdlsOptions> list;
  for (const bool homo_regions : {false, true})
    for (const int leaves : {0, 8, 32})
      for (const bool early_test : {false, true})
        for (const int layers_per_pass : {1, 2, 7})
          for (const bool back_to_front : {false, true})
            list.push_back({homo_regions, leaves, 3, early_test, layers_per_pass, back_to_front});
  return list;
}

std::string text_of(const VdlsOptions& o) {
  return fmt::format("homo {} leaves {} early {} layers {} btf {}", o.homo_regions, o.leaves, o.early_test,
                     o.layers_per_pass, o.back_to_front);
}

// The samples are the ray caster's, so the picture is, too, whatever the speed-ups.
TEST_F(Layers, EverySpeedUpGivesTheRayCastersPicture) {
  Scene scene = dvr_scene(builtin("sphere?n=24"), "smooth-haze");
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  const Image expected = render(scene, camera, {40, 40}, Engine::raycaster);
  EXPECT_GT(expected.at(20, 20).a, 0.1f);
  for (const VdlsOptions& options : all_options()) {
    scene.rendering.vdls = options;
    EXPECT_LT(largest_difference(render(scene, camera, {40, 40}, Engine::vdls), expected), rounding)
        << text_of(options);
  }
}

// From everywhere: afar, beside the volume, in it, with it behind the eye or partly so, and along an axis,
// where each ray's length is a whole number of steps.
TEST_F(Layers, FromEverywhere) {
  const auto volume = builtin("gyroid?n=20");
  const Grid& grid = volume->grid;
  const glm::dvec3 middle = grid.origin + 0.5 * grid.box_size(), size = grid.box_size();
  std::vector<Camera> cameras{whole_volume_camera(grid, 1), along_z(grid, 1.5 * size.x),
                              along_z(grid, size.x)};
  for (const glm::dvec3 eye : {glm::dvec3(0), {0.2, 0.1, -0.3}, {0, 0, -0.5}, {0.6, 0, 0.2}, {0.5, 0.5, 0.5}})
    for (const glm::dvec3 towards : {glm::dvec3(0.3, -0.2, 1), {-1, 0.1, -0.2}})
      cameras.push_back(
          {middle + eye * size, middle + (eye + towards) * size, {0, 1, 0}, 70, Projection::perspective, ""});
  for (std::size_t i = 0, count = cameras.size(); i < count; ++i) {
    cameras.push_back(cameras[i]);
    cameras.back().projection = Projection::parallel;
  }
  for (const double step : {0.25, 1.0, 3.7, 100.0})
    for (const Camera& camera : cameras)
      for (const VdlsOptions& options : {VdlsOptions{}, VdlsOptions::basic()})
        EXPECT_LT(difference(dvr_scene(volume, "smooth-haze", step), camera, options), rounding)
            << step << ' ' << text_of(options);
}

// However many delta vectors are added up, they end where the ray caster's samples do.
TEST_F(Layers, SmallStepsDoNotDrift) {
  const auto volume = builtin("sphere?n=9");
  const Scene scene = dvr_scene(volume, "onion", 0.004);
  const Camera camera = whole_volume_camera(volume->grid, 1);
  for (const VdlsOptions& options : {VdlsOptions{}, VdlsOptions{.back_to_front = true}})
    EXPECT_LT(difference(scene, camera, options), rounding) << text_of(options);
  EXPECT_GT(renderer.vdls().last_work().layers, 1500);
}

// Planes only bring new entry and exit points; grids need not be cubes, nor their cells.
TEST_F(Layers, ClipBoxesAndOddGrids) {
  Volume odd = make_builtin("gyroid?n=21");
  odd.grid.spacing = {1, 1.7, 0.6};
  odd.grid.origin = {-7, 100, 0.5};
  const auto volume = std::make_shared<const Volume>(odd);
  Scene scene = dvr_scene(volume, "smooth-haze");
  const glm::dvec3 low = odd.grid.box_min(), size = odd.grid.box_size();
  for (const ClipBox& box :
       {ClipBox{low - size, low + 2.0 * size, ""},
        {low + glm::dvec3(0.31, 0.2, 0.05) * size, low + glm::dvec3(0.8, 0.9, 0.55) * size, ""},
        {low + size, low + 2.0 * size, ""}})
    for (const glm::ivec2 pixels : {glm::ivec2(48, 31), {17, 50}})
      for (const VdlsOptions& options : {VdlsOptions{}, VdlsOptions::basic()}) {
        scene.rendering.clip_box = box;
        EXPECT_LT(difference(scene, whole_volume_camera(odd.grid, 1), options, pixels), rounding);
      }
}

// The counts are the ray caster's, but for the transparent samples that are leapt over.
TEST_F(Layers, Counts) {
  Scene scene = dvr_scene(builtin("sphere?n=24"), "smooth-haze");
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  scene.rendering.skipping = false;
  const auto expected = counts(scene, camera, {32, 32}, Engine::raycaster);
  scene.rendering.vdls = VdlsOptions::basic();
  const auto all = counts(scene, camera, {32, 32}, Engine::vdls);
  scene.rendering.vdls = {};
  scene.rendering.skipping = true;
  const auto leapt = counts(scene, camera, {32, 32}, Engine::vdls);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(all[i].samples, expected[i].samples);
    EXPECT_EQ(all[i].hit, expected[i].hit);
    EXPECT_LE(leapt[i].samples, all[i].samples);
  }
}

// A picture drawn in tiles is the same.
TEST_F(Layers, Tiles) {
  Scene scene = dvr_scene(builtin("gyroid?n=20"), "smooth-haze");
  scene.rendering.engine = Engine::vdls;
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  const Image whole = render(scene, camera, {40, 40}, Engine::vdls);
  gl::RenderTarget target({40, 40}, false);
  for (const Tile& tile : {Tile{{0, 0}, {40, 7}}, {{0, 7}, {13, 40}}, {{13, 7}, {40, 40}}})
    renderer.draw(scene, camera, target, tile);
  EXPECT_EQ(target.read_color().pixels, whole.pixels);
}

// What is known of a tile from before is as good, however many pictures were drawn since.
TEST_F(Layers, AreDrawnWithoutWaiting) {
  Scene scene = dvr_scene(builtin("gyroid?n=20"), "smooth-haze");
  scene.rendering.engine = Engine::vdls;
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  for (const int leaves : {0, scene.rendering.vdls.leaves}) {
    scene.rendering.vdls.leaves = leaves;
    const Image whole = render(scene, camera, {40, 40}, Engine::vdls);
    gl::RenderTarget target({40, 40}, false), at_once({40, 40}, false);
    std::vector<std::pair<Tile, gl::PendingBuffer>> begun;
    for (const Tile& tile : {Tile{{0, 0}, {40, 7}}, {{0, 7}, {13, 40}}, {{13, 7}, {40, 40}}})
      begun.emplace_back(tile, *renderer.begin(scene, camera, target, tile));
    render(scene, camera, {17, 60}, Engine::vdls);
    for (const auto& [tile, known] : begun) renderer.draw(scene, camera, target, tile, &known);
    EXPECT_EQ(target.read_color().pixels, whole.pixels);
    renderer.draw_at_once(scene, camera, at_once);
    EXPECT_EQ(at_once.read_color().pixels, whole.pixels) << "layers beyond a ray's end add nothing";
  }
}

/// Counts what is drawn, as long as it lives.
class Draws {
 public:
  int count() const { return count_; }

 private:
  int count_ = 0;
  Watched<epoxy_glDrawArrays, decltype(epoxy_glDrawArrays)> draw_{[this](auto...) { ++count_; }};
};

TEST_F(Layers, AreSetUpAgainOnlyAfterAnotherPicture) {
  Scene scene = dvr_scene(builtin("gyroid?n=20"), "smooth-haze");
  scene.rendering.engine = Engine::vdls;
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  const Tile tile{{5, 6}, {40, 40}};
  gl::RenderTarget target({40, 40}, false), other({40, 40}, false);
  const auto draws_of = [&](bool draws_another) {
    const gl::PendingBuffer begun = *renderer.begin(scene, camera, target, tile);
    if (draws_another) renderer.draw(scene, camera, other);
    const Draws draws;
    renderer.draw(scene, camera, target, tile, &begun);
    return draws.count();
  };
  const int alone = draws_of(false);
  EXPECT_EQ(alone, renderer.vdls().last_work().passes);
  const Image one = target.read_color();
  EXPECT_EQ(draws_of(true), alone + 1);
  EXPECT_EQ(target.read_color().pixels, one.pixels);
  EXPECT_EQ(draws_of(false), alone);
}

TEST_F(Layers, AtOnceAreNotWithoutEnd) {
  Scene scene = dvr_scene(builtin("sphere?n=32"), "smooth-haze");
  scene.rendering.engine = Engine::vdls;
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  gl::RenderTarget target({8, 8}, false);
  scene.rendering.step = 0.01;
  EXPECT_NO_THROW(renderer.draw_at_once(scene, camera, target));
  const Image at_once = target.read_color();
  EXPECT_EQ(at_once.pixels, render(scene, camera, {8, 8}, Engine::vdls).pixels);
  scene.rendering.step = 0.001;
  EXPECT_THROW(renderer.draw_at_once(scene, camera, target), Error);
}

// What it does not render, it says.
TEST_F(Layers, RefusesWhatItDoesNotRender) {
  Scene scene = dvr_scene(builtin("sphere?n=8"), "smooth-haze");
  EXPECT_EQ(why_not_vdls(scene), "");
  gl::RenderTarget target({8, 8}, false);
  for (const Mode mode : {Mode::both, Mode::peak_xor_dvr, Mode::peak_only}) {
    scene.rendering.mode = mode;
    EXPECT_EQ(why_not_vdls(scene),
              "the vdls engine renders DVR_ONLY alone, and rendering.mode is " + std::string(name_of(mode)));
    EXPECT_THROW(renderer.vdls().draw(scene, {}, target, {{0, 0}, {8, 8}}), Error);
  }
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.placement = Placement::eye;
  EXPECT_NE(why_not_vdls(scene), "");
  scene.rendering.placement = Rendering{}.placement;
  Volume holed = *scene.volume;
  holed.values.floats()[5] = std::numeric_limits<float>::quiet_NaN();
  holed.statistics = compute_statistics(holed.grid, holed.values);
  scene.volume = std::make_shared<const Volume>(holed);
  EXPECT_NE(why_not_vdls(scene).find("1 without"), std::string::npos);
}

// The window draws on after an error: nothing may stay on.
TEST_F(Layers, LeaveNothingOnWhenTheyFail) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("crest-layers-" + std::to_string(::getpid()));
  fs::copy(test::source_folder() / "render/shaders", folder);
  std::ofstream(folder / "vdls_layers.frag", std::ios::app) << "}";
  Vdls vdls(std::make_shared<Resources>(folder));
  const Scene scene = dvr_scene(builtin("sphere?n=8"), "smooth-haze");
  gl::RenderTarget target({8, 8}, false);
  const Camera camera = whole_volume_camera(scene.volume->grid, 1);
  EXPECT_THROW(vdls.draw(scene, camera, target, {{0, 0}, {8, 8}}), Error);
  EXPECT_FALSE(glIsEnabled(GL_SCISSOR_TEST));
  EXPECT_FALSE(glIsEnabled(GL_BLEND));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace crest::testing
