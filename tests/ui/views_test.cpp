#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "render/scene/camera.h"
#include "tests/ui/harness.h"

namespace crest::test {
namespace {

using Views = Studio;

double distance(const Camera& camera) { return glm::length(camera.eye - camera.target); }

TEST_F(Views, FourPicturesOfAboutTheSameSize) {
  for (const glm::ivec2 size : requests.view_pixels) {
    EXPECT_NEAR(size.x, 540, 40);
    EXPECT_NEAR(size.y, 500, 40);
  }
}

TEST_F(Views, LeftDragTurnsAndUndoIsOneStep) {
  const Camera before = camera_of(document.preset, volume.grid, aspect_of(requests.view_pixels[0]));
  const ImVec2 middle = center_of("view1");
  drag(middle, {middle.x + 60, middle.y + 25});
  ASSERT_TRUE(document.preset.camera);
  EXPECT_NEAR(distance(*document.preset.camera), distance(before), 1e-9);
  EXPECT_GT(glm::length(document.preset.camera->eye - before.eye), 1);
  EXPECT_EQ(document.preset.camera->target, before.target);
  ctrl('Z');
  EXPECT_FALSE(document.preset.camera);
}

TEST_F(Views, ThePictureFollowsThePan) {
  const ImVec2 middle = center_of("view0");
  const Camera before = camera_of(document.preset, volume.grid, aspect_of(requests.view_pixels[0]));
  drag(middle, {middle.x + 60, middle.y}, 2);
  ASSERT_TRUE(document.preset.camera);
  const Camera camera = *document.preset.camera;
  EXPECT_NEAR(glm::length(camera.eye - before.eye), glm::length(camera.target - before.target), 1e-9);
  const double height = 2 * std::tan(camera.fov_y_degrees * std::acos(-1.0) / 360) * distance(camera);
  EXPECT_NEAR(glm::length(camera.eye - before.eye), 60 * height / requests.view_pixels[0].y, 1e-6);
  EXPECT_LT(camera.eye.x, before.eye.x) << "the picture goes right, so the camera goes left";
}

TEST_F(Views, WheelDolliesAndResetForgetsTheCamera) {
  move_to(center_of("view3"));
  const Camera before = camera_of(document.preset, volume.grid, aspect_of(requests.view_pixels[3]));
  for (int i = 0; i < 4; ++i) wheel(1);
  ASSERT_TRUE(document.preset.camera);
  EXPECT_LT(distance(*document.preset.camera), 0.7 * distance(before));
  key('R');
  EXPECT_FALSE(document.preset.camera);
  frames(60);
  ctrl('Z');
  EXPECT_TRUE(document.preset.camera);
}

// One key; what is reset keeps the projection, and one undo takes it back.
TEST_F(Views, SwitchToParallelProjectionAndBack) {
  const Camera before = camera_of(document.preset, volume.grid, aspect_of(requests.view_pixels[0]));
  key('O');
  ASSERT_TRUE(document.preset.camera);
  EXPECT_EQ(document.preset.camera->projection, Projection::parallel);
  EXPECT_EQ(document.preset.camera->eye, before.eye);
  move_to(center_of("view0"));
  for (int i = 0; i < 4; ++i) wheel(1);
  EXPECT_LT(half_height_at_target(*document.preset.camera), 0.7 * half_height_at_target(before));
  key('R');
  ASSERT_TRUE(document.preset.camera);
  EXPECT_EQ(document.preset.camera->projection, Projection::parallel);
  EXPECT_GT(half_height_at_target(*document.preset.camera), 0.8 * half_height_at_target(before));
  click("menu/View");
  click("Parallel projection");
  EXPECT_EQ(document.preset.camera->projection, Projection::perspective);
  ctrl('Z');
  EXPECT_EQ(document.preset.camera->projection, Projection::parallel);
}

TEST_F(Views, AViewIsEnlargedAndPutBack) {
  const int before = requests.view_pixels[2].x;
  click("enlarge2");
  frame();
  EXPECT_GT(requests.view_pixels[2].x, before * 1.9);
  EXPECT_EQ(requests.view_pixels[0], glm::ivec2(0));
  key_of(ImGuiKey_Escape);
  frame();
  EXPECT_EQ(requests.view_pixels[2].x, before);
  double_click(center_of("view1"));
  EXPECT_EQ(state->views.enlarged, 1);
}

TEST_F(Views, GoOnToTheExactPictureUnlessToldOtherwise) {
  EXPECT_EQ(requests.shown_picture, ShownPicture::exact);
  EXPECT_EQ(key('X').shown_picture, ShownPicture::as_set);
  EXPECT_EQ(key('B').shown_picture, ShownPicture::error_bound);
  EXPECT_EQ(key('B').shown_picture, ShownPicture::exact);
  key('B');
  EXPECT_EQ(key('X').shown_picture, ShownPicture::as_set) << "there is no bound of samples";
  EXPECT_EQ(key('X').shown_picture, ShownPicture::exact);
}

TEST_F(Views, AWarningStandsInItsViewAlone) {
  for (int i = 0; i < view_count; ++i) EXPECT_FALSE(has(fmt::format("warning{}", i)));
  const int quiet = ImGui::GetDrawData()->CmdListsCount;
  inputs.views[2].warnings = {std::string(200, 'w'), "A pixel may be off."};
  frames(2);
  for (int i = 0; i < view_count; ++i) EXPECT_EQ(has(fmt::format("warning{}", i)), i == 2);
  EXPECT_EQ(ImGui::GetDrawData()->CmdListsCount, quiet) << "no tooltip yet";
  move_to(center_of("warning2"));
  frames(2);
  EXPECT_EQ(ImGui::GetDrawData()->CmdListsCount, quiet + 1) << "the tooltip";
  inputs.views[2].warnings.clear();
  frames(2);
  EXPECT_FALSE(has("warning2"));
  EXPECT_EQ(ImGui::GetDrawData()->CmdListsCount, quiet);
}

TEST_F(Views, WhatIsReadIsToldAndCanBeCancelled) {
  EXPECT_FALSE(has("cancel loading"));
  inputs.loading = "large.nrrd";
  frames(2);
  EXPECT_FALSE(requests.cancel_loading);
  bool cancelled = false;
  const ImVec2 place = center_of("cancel loading");
  move_to(place);
  ImGui::GetIO().MouseDown[0] = true;
  cancelled |= frame().cancel_loading;
  ImGui::GetIO().MouseDown[0] = false;
  cancelled |= frame().cancel_loading;
  EXPECT_TRUE(cancelled);
  inputs.loading.clear();
  frame();
  EXPECT_FALSE(has("cancel loading"));
}

TEST_F(Views, ABarIsFilledByHowMuchIsRead) {
  const auto filled = [&](double share) {
    inputs.loading_share = share;
    frame();
    const auto [from, to] = state->widgets.items.at("loaded share");
    return to.x - from.x;
  };
  inputs.loading = "large.nrrd";
  frame();
  EXPECT_FALSE(has("loaded share")) << "nobody has told";
  const float whole = filled(1);
  EXPECT_GT(whole, 0);
  EXPECT_FLOAT_EQ(filled(0.25), whole / 4);
  EXPECT_EQ(filled(0), 0);
  EXPECT_TRUE(has("cancel loading"));
  inputs.loading.clear();
  frame();
  EXPECT_FALSE(has("loaded share"));
}

}  // namespace
}  // namespace crest::test
