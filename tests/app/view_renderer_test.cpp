#include "app/view_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "app/export_picture.h"
#include "app/next_slice.h"
#include "app/ray_inspector.h"
#include "app/slice_pictures.h"
#include "app/view_difference.h"
#include "presets/preset_file.h"
#include "render/gl/filter_weights.h"
#include "render/scene/camera.h"
#include "render/scene/error_colors.h"
#include "render/scene/exact.h"
#include "render/volume/builtin.h"
#include "tests/debug_context.h"
#include "tests/gl_waits.h"

namespace crest {
namespace {

class Views : public ::testing::Test {
 protected:
  Views() {
    const auto volume = std::make_shared<const Volume>(make_builtin("gyroid?n=24"));
    for (std::size_t i = 0; i < view_count; ++i) {
      requests[i] = {
          make_scene(volume, load_preset("dirac-shell")), whole_volume_camera(volume->grid, 1), {64, 48}};
      requests[i].scene.rendering.mode = view_modes[i];
    }
  }
  /// Works until nothing is left to do; how often that took.
  int finish(double budget_ms, bool interactive) {
    using Clock = std::chrono::steady_clock;
    const auto give_up = Clock::now() + std::chrono::minutes(5);  // the device works beside it
    for (int calls = 1; Clock::now() < give_up; ++calls) {
      views.work(requests, budget_ms, interactive);
      const ViewPicture first = views.picture(0);
      saw_preview |= first.is_exact && first.texture != 0 && first.coarseness == 1 && first.progress == 0;
      if (!views.is_busy()) return calls;
    }
    return -1;
  }
  void expect_all_done() {
    EXPECT_EQ(views.error(), "");
    for (int i = 0; i < view_count; ++i) {
      EXPECT_EQ(views.shown_versions()[std::size_t(i)], views.wanted_versions()[std::size_t(i)]);
      const ViewPicture picture = views.picture(i);
      EXPECT_EQ(picture.coarseness, 1);
      EXPECT_EQ(picture.progress, 1);
      EXPECT_GT(picture.frame_ms, 0) << "the device's times came in";
      EXPECT_GT(picture.samples_per_ray, 0);
    }
  }

  testing::DebugContext context;
  ViewRenderer views;
  bool saw_preview = false;  ///< of the first view: sharp, and nothing of it exact yet
  std::array<ViewRequest, picture_count> requests;
};

TEST_F(Views, AreFinishedHoweverSmallTheBudget) {
  EXPECT_GT(finish(1e-3, true), view_count) << "a slice of a view at a time";
  expect_all_done();
  for (ViewRequest& request : requests) request.camera.fov_y_degrees += 1;
  EXPECT_GT(finish(1e9, false), 0);
  expect_all_done();
}

TEST_F(Views, NothingOfAVolumeIsHeldOnceNoneIsShown) {
  const std::weak_ptr<const Volume> volume = requests[0].scene.volume;
  views.keep_colors(true);
  finish(1e9, false);
  ASSERT_GT(views.renderer().resources().held.bytes(), 0u);
  ASSERT_TRUE(glIsTexture(GLuint(views.picture(0).texture)));
  const auto shown = GLuint(views.picture(0).texture);

  requests = {};
  for (int hidden = 0; hidden < 3; ++hidden) views.work(requests, 1e9, false);
  EXPECT_EQ(GLuint(views.picture(0).texture), shown) << "a hidden view has its picture when it comes back";
  views.close();
  views.work(requests, 1e9, false);
  EXPECT_TRUE(glIsTexture(shown)) << "the frame that is being drawn may name it";
  views.work(requests, 1e9, false);
  EXPECT_FALSE(glIsTexture(shown));
  EXPECT_EQ(views.renderer().resources().held.bytes(), 0u);
  EXPECT_EQ(views.renderer().resources().programs.count(), 0u);
  for (int i = 0; i < view_count; ++i) EXPECT_EQ(views.picture(i).texture, 0u);
  EXPECT_FALSE(views.is_busy());
  EXPECT_TRUE(volume.expired());
}

TEST_F(Views, TheDifferenceOfTwoPicturesIsDrawnAndMeasured) {
  requests[compared_picture] = requests[2];
  requests[compared_picture].scene.rendering.background =
      requests[2].scene.rendering.background = {0.2, 0, 0};
  finish(1e9, false);
  EXPECT_EQ(views.colors(0), nullptr) << "nobody asked to keep it";
  views.keep_colors(true);
  finish(1e9, false);
  ASSERT_TRUE(views.colors(0));
  ASSERT_TRUE(views.colors(compared_picture));

  ViewDifference difference;
  Comparison comparison{
      .view = 2, .with = {}, .follows = {}, .kind = ComparisonKind::difference, .amplification = 4};
  const auto measure = [&] {
    do difference.update(views, comparison);
    while (difference.is_busy());
  };
  measure();
  EXPECT_NE(difference.picture().texture, 0u);
  EXPECT_TRUE(difference.picture().is_measured);
  EXPECT_EQ(difference.picture().max, 0) << "the same picture";

  comparison.view = 0;
  difference.update(views, comparison, false);
  EXPECT_NE(difference.picture().texture, 0u);
  EXPECT_FALSE(difference.picture().is_measured) << "the numbers are those of the other pair";
  EXPECT_FALSE(difference.picture().has_failed);
  measure();
  EXPECT_TRUE(difference.picture().is_measured);
  const Image a = views.colors(0)->read_color(), b = views.colors(compared_picture)->read_color();
  std::vector<std::uint8_t> drawn(a.pixels.size() * 4);
  glGetTextureImage(GLuint(difference.picture().texture), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(drawn.size()),
                    drawn.data());
  float most = 0;
  double squares = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const float ground = channel == 0 ? 0.2F : 0;
      const float off = std::abs(b.pixels[i][channel] + (1 - b.pixels[i].a) * ground - a.pixels[i][channel]);
      most = std::max(most, off);
      squares += double(off) * double(off);
      EXPECT_NEAR(drawn[4 * i + std::size_t(channel)], 255 * std::min(4 * off, 1.0F), 0.51) << i;
    }
  EXPECT_GT(most, 0.1);
  EXPECT_NEAR(difference.picture().max, most, 1e-6);
  EXPECT_NEAR(difference.picture().rmse, std::sqrt(squares / (3.0 * double(a.pixels.size()))), 1e-6);
  EXPECT_GT(difference.picture().share, 0.5) << "the background differs";

  views.keep_colors(false);
  finish(1e9, false);
  difference.update(views, comparison);
  EXPECT_EQ(difference.picture().texture, 0u);
  EXPECT_FALSE(difference.picture().is_measured);
}

/// The first reading of a buffer fails, as where the device has no room.
class FailsOnce {
 public:
  int reads() const { return reads_; }

 private:
  int reads_ = 0;
  testing::Watched<epoxy_glGetNamedBufferSubData, decltype(epoxy_glGetNamedBufferSubData)> read_{
      [this](GLuint, GLintptr, GLsizeiptr, void*) {
        if (++reads_ > 1) return;
        glDisable(GL_DEBUG_OUTPUT);
        glEnable(GL_INVALID_ENUM);  // an error that the driver has to tell
        glEnable(GL_DEBUG_OUTPUT);
      }};
};

TEST_F(Views, NumbersThatCannotBeReadAreNotReadAgain) {
  requests[compared_picture] = requests[2];
  views.keep_colors(true);
  finish(1e9, false);
  ViewDifference difference;
  Comparison comparison{
      .view = 0, .with = {}, .follows = {}, .kind = ComparisonKind::difference, .amplification = 4};
  const FailsOnce failing;
  const auto measure = [&] {
    do difference.update(views, comparison);
    while (difference.is_busy());
  };
  EXPECT_THROW(measure(), std::exception);
  EXPECT_FALSE(difference.is_busy());
  EXPECT_FALSE(difference.picture().is_measured);
  EXPECT_TRUE(difference.picture().has_failed);
  measure();
  EXPECT_EQ(failing.reads(), 1);
  comparison.view = 1;
  measure();
  EXPECT_TRUE(difference.picture().is_measured) << "another pair is";
  EXPECT_FALSE(difference.picture().has_failed);
}

TEST_F(Views, AnExportsPictureThatCannotBeReadIsNotReadAgain) {
  const Preset preset = load_preset("dirac-shell");
  ExportPictureMaker exported;
  const FailsOnce failing;
  const auto draw = [&] {
    do exported.update(views.renderer(), requests[0].scene.volume, preset, {});
    while (exported.is_busy());
  };
  EXPECT_THROW(draw(), std::exception);
  draw();
  EXPECT_EQ(failing.reads(), 1);
  EXPECT_EQ(exported.picture().texture, 0u);
}

TEST_F(Views, NothingThatTheWindowShowsIsWaitedFor) {
  requests[1].scene.rendering = exact_rendering(requests[1].scene.rendering);
  requests[3].scene.rendering.mode = Mode::dvr_only;
  requests[3].scene.rendering.engine = Engine::vdls;
  requests[compared_picture] = requests[2];
  views.keep_colors(true);
  views.renderer().resources().weight_error = gl::measure_weight_error();  // once a context, and it waits
  RayInspector rays;
  ExportPictureMaker exported;
  SlicePictures slices;
  ViewDifference difference;
  const Comparison comparison{
      .view = 0, .with = {}, .follows = {}, .kind = ComparisonKind::difference, .amplification = 4};

  const testing::GlWaits waits;
  const auto until_all_is_there = [&](bool interactive) {
    do {
      views.work(requests, 3, interactive);
      difference.update(views, comparison);
      exported.update(views.renderer(), requests[0].scene.volume, load_preset("dirac-shell"), {});
      rays.want(requests[0].scene, requests[0].camera, {0, {32, 24}, requests[0].size});
      rays.work(views.renderer());
      slices.update(views.renderer().resources(), requests[0].scene,
                    {.cursor = glm::dvec3(0.5), .pixels = {glm::ivec2(20), {9, 9}, {9, 9}}});
    } while (views.is_busy() || difference.is_busy() || exported.is_busy() || rays.is_busy());
    const gl::PendingRead left(*views.display(0));  // as a thumbnail
    while (!left.is_over()) views.work(requests, 3, interactive);
    EXPECT_EQ(left.shown().size(), 64u * 48u);
  };
  until_all_is_there(true);
  requests[0].camera.fov_y_degrees += 1;
  requests[3].camera.fov_y_degrees += 1;
  until_all_is_there(false);
  EXPECT_EQ(views.error(), "");
  EXPECT_GT(difference.picture().rmse, 0);
  EXPECT_NE(exported.picture().texture, 0u);
  EXPECT_FALSE(rays.inspection()->modes[2]->steps.empty());
  EXPECT_EQ(waits.count(), 0);

  views.colors(0)->read_color();
  EXPECT_EQ(waits.count(), 1) << "one that waits is counted";
}

TEST(Slices, OfA4KPictureAreFewPixelsWhereTheyCostMuch) {
  const glm::ivec2 size{3840, 2160};
  const auto pixels_of = [](const Tile& slice) {
    const glm::ivec2 part = slice.end - slice.begin;
    return part.x * part.y;
  };
  for (const double wanted : {1.0, 1000.0, 8000.0, 100000.0}) {
    std::vector<std::uint8_t> drawn(std::size_t(size.x) * std::size_t(size.y));
    for (glm::ivec2 begin{0}; begin.y < size.y;) {
      const Tile slice = next_slice(size, begin, wanted);
      ASSERT_LE(pixels_of(slice), std::max(wanted, 4 * 16.0));
      for (int y = slice.begin.y; y < slice.end.y; ++y)
        for (int x = slice.begin.x; x < slice.end.x; ++x)
          ++drawn[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
      begin = after(slice, size);
    }
    EXPECT_EQ(std::ranges::count(drawn, 1), std::ptrdiff_t(drawn.size())) << "each pixel once";
  }
  EXPECT_EQ(next_slice({640, 480}, {0, 0}, 6400).end, glm::ivec2(640, 10)) << "whole rows where they fit";
}

// A table for one step length is made once an edit: a coarse picture, which would step further, takes the
// same.
TEST_F(Views, ACoarsePictureMakesNoTableOfItsOwn) {
  for (std::size_t i = 1; i < view_count; ++i) requests[i].size = {0, 0};
  requests[0].size = {512, 384};  // takes so long that a coarse picture comes first
  requests[0].scene.rendering.mode = Mode::dvr_only;
  requests[0].scene.rendering.skipping = false;
  const auto made_by_an_edit = [&](ClassificationMethod method) {
    requests[0].scene.rendering.classification = method;
    requests[0].scene.rendering.placement = Placement::entry;
    finish(1e-3, true);
    const auto& held = views.renderer().resources().held;
    const int before = held.made();
    requests[0].scene.tf.points.front().color.r += 0.01;
    EXPECT_GT(finish(1e-3, true), 2) << "coarse, full and counted";
    EXPECT_EQ(views.error(), "");
    return held.made() - before;
  };
  const int with_a_table = made_by_an_edit(ClassificationMethod::preintegrated_table);
  EXPECT_EQ(with_a_table, 2) << "the classification, and one table";
}

/// What a view shows, as RGB in [0, 1].
std::vector<glm::vec3> shown(const ViewPicture& picture, glm::ivec2 size) {
  std::vector<glm::vec3> pixels(std::size_t(size.x) * std::size_t(size.y));
  glGetTextureImage(GLuint(picture.texture), 0, GL_RGB, GL_FLOAT, GLsizei(pixels.size() * sizeof(glm::vec3)),
                    pixels.data());
  return pixels;
}

// While the person acts the small picture stays, as slices of the one in full are drawn; then all that was
// drawn of it appears, also where the first slice that is shown begins within a row.
TEST_F(Views, WhatWasDrawnWhileThePersonActedIsShownAfterwards) {
  const glm::ivec2 size{4096, 16};
  ASSERT_LT(next_slice(size, {0, 0}, 8000).end.x, size.x)
      << "a row of slices, by the first guess of the costs";
  for (const int slices : {1, 4}) {
    ViewRenderer fresh;
    std::array<ViewRequest, picture_count> wanted;
    wanted[0] = requests[0];
    wanted[0].size = size;
    wanted[0].camera.target = {0.4, 0.3, 0.1};
    wanted[0].camera.eye = {0, 0, 0};  // within the volume: all rays meet it
    const auto work = [&](bool interactive) { fresh.work(wanted, 1e-3, interactive); };
    while (fresh.picture(0).texture == 0) work(true);
    ASSERT_GT(fresh.picture(0).coarseness, 1);
    {
      int draws = 0;
      const testing::Watched<epoxy_glDrawArrays, decltype(epoxy_glDrawArrays)> watched(
          [&](auto...) { ++draws; });
      for (int slice = 0; slice < slices; ++slice)
        for (const int before = draws; draws == before;) work(true);
    }
    if (slices == 1) {
      EXPECT_EQ(fresh.picture(0).progress, 0) << "within the first rows";
    }
    const double drawn_before = fresh.picture(0).progress;
    while (fresh.picture(0).progress <= drawn_before) work(false);
    const std::size_t pixels = std::size_t(std::lround(fresh.picture(0).progress * size.y) * size.x);
    gl::RenderTarget target(size, false);
    fresh.renderer().draw(wanted[0].scene, wanted[0].camera, target);
    const Image full = target.read_color();
    const std::vector<glm::vec3> seen = shown(fresh.picture(0), size);
    for (std::size_t i = 0; i < pixels; ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(seen[i][c], full.pixels[i][c], 0.51 / 255) << slices << ' ' << i;
  }
}

// Of an exact scene comes first what samples make of it, and at last what the exact march does.
TEST_F(Views, GoOnToTheExactPicture) {
  for (ViewRequest& request : requests) request.scene.rendering = exact_rendering(request.scene.rendering);
  const glm::ivec2 size = requests[0].size = {640, 480};  // takes so long that a preview comes first
  EXPECT_GT(finish(1e-3, true), 0);
  EXPECT_TRUE(saw_preview);
  expect_all_done();
  gl::RenderTarget target(size, false);
  views.renderer().draw(requests[0].scene, requests[0].camera, target);
  const Image exact = target.read_color();
  const std::vector<glm::vec3> pixels = shown(views.picture(0), size);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixels[i][c], exact.pixels[i][c], 0.51 / 255) << i;
  for (int i = 0; i < view_count; ++i) {
    EXPECT_TRUE(views.picture(i).is_exact);
    EXPECT_GT(views.picture(i).share_within.value_or(0), 0.9);
  }
}

// In place of the picture: black where nothing is. Nothing else is drawn for it, once the picture is there.
TEST_F(Views, ShowHowFarAPixelMayBeOff) {
  for (ViewRequest& request : requests) {
    request.scene.rendering = exact_rendering(request.scene.rendering);
    request.size = {64, 64};
  }
  EXPECT_GT(finish(1e9, false), 0);
  for (ViewRequest& request : requests) request.error_bound = true;
  views.work(requests, 1e-3, true);
  EXPECT_EQ(views.picture(2).coarseness, 1) << "the picture stays";
  EXPECT_GT(finish(1e9, false), 0);
  expect_all_done();
  const auto pixels = shown(views.picture(2), requests[2].size);
  const float brightest = std::ranges::max(pixels, {}, [](glm::vec3 p) { return p.r; }).r;
  EXPECT_NEAR(pixels.front().r, error_color(0).r, 1.0 / 255);
  EXPECT_GT(brightest, error_color(2e-5).r) << "float rounds";
}

// What cannot be drawn leaves nothing behind that keeps the others from being drawn and timed.
TEST_F(Views, AViewThatCannotBeDrawnDoesNotStopTheOthers) {
  EXPECT_GT(finish(5, false), 0);
  for (int i = 0; i < view_count; ++i) EXPECT_TRUE(views.shows_what_is_wanted(i));
  requests[0].camera.target = requests[0].camera.eye;  // no view
  EXPECT_GT(finish(5, false), 0);
  EXPECT_NE(views.error(), "");
  EXPECT_TRUE(views.display(0)) << "the earlier picture";
  EXPECT_FALSE(views.shows_what_is_wanted(0));
  EXPECT_TRUE(views.shows_what_is_wanted(1));
  for (int i = 1; i < view_count; ++i) EXPECT_GT(views.picture(i).frame_ms, 0);
  requests[0] = requests[1];
  EXPECT_GT(finish(5, false), 0);
  expect_all_done();
}

}  // namespace
}  // namespace crest
