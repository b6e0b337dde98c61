#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render/scene/camera.h"
#include "tests/ui/harness.h"
#include "ui/transfer_function_editor.h"

namespace crest::test {
namespace {

using Panels = Studio;
using Views = Studio;
using Hostile = Studio;

double distance(const Camera& camera) { return glm::length(camera.eye - camera.target); }

TEST_F(Panels, APeakIsSwitchedOffAndOn) {
  ASSERT_EQ(inputs.peaks.size(), 1U);
  EXPECT_TRUE(inputs.peaks[0].shown);
  click("peak0.eye");
  EXPECT_EQ(tf().points[2].surface.mode, SurfaceMode::off);
  EXPECT_FALSE(inputs.peaks[0].shown);
  click("peak0.eye");
  EXPECT_EQ(tf().points[2].surface.mode, SurfaceMode::automatic);
  EXPECT_TRUE(inputs.peaks[0].shown);
}

TEST_F(Panels, APeakIsEditedByNumbers) {
  type("##peak0.value", "48.0625");
  EXPECT_EQ(tf().points[2].value, 48.0625);
  EXPECT_EQ(tf().points[1].value, 18.0625) << "its feet go along";
  type("##peak0.opacity", "0.3333333333333333");
  EXPECT_EQ(tf().points[2].opacity, 0.3333333333333333);
  type("##peak0.width", "1");
  EXPECT_NEAR(tf().points[3].value - tf().points[1].value, 1, 1e-12);
}

TEST_F(Panels, APeakIsSoloDuplicatedAndRemoved) {
  tf().points =
      points_of({{0, 0}, {29.5, 0}, {30, 0.9}, {30.5, 0}, {69.5, 0}, {70, 0.7}, {70.5, 0}, {100, 0}});
  frames(2);
  click("peak1.solo");
  EXPECT_EQ(inputs.surfaces.size(), 1U);
  EXPECT_EQ(inputs.surfaces[0].value, 70);
  click("peak1.solo");
  EXPECT_EQ(inputs.surfaces.size(), 2U);
  click("peak0.duplicate");
  for (const char c : {'9', '0'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(2);
  key_of(ImGuiKey_Enter);
  frames(2);
  ASSERT_EQ(inputs.peaks.size(), 3U);
  EXPECT_EQ(inputs.peaks[2].value, 90);
  EXPECT_EQ(inputs.peaks[2].opacity, 0.9);
  EXPECT_EQ(inputs.peaks[2].width, 1);
  click("peak0.remove");
  EXPECT_EQ(tf().points,
            points_of({{0, 0}, {69.5, 0}, {70, 0.7}, {70.5, 0}, {89.5, 0}, {90, 0.9}, {90.5, 0}, {100, 0}}));
}

TEST_F(Panels, OpacityAndWidthAreDraggedInTheList) {
  const ImVec2 opacity = center_of("##peak0.opacity");
  drag(opacity, {opacity.x - 60, opacity.y});
  EXPECT_NEAR(tf().points[2].opacity, 0.8 - 0.3, 0.02);
  ctrl('Z');
  EXPECT_EQ(tf().points[2].opacity, 0.8) << "a drag is one step";
  drag(opacity, {opacity.x + 400, opacity.y});
  EXPECT_EQ(tf().points[2].opacity, 1);
  const ImVec2 width = center_of("##peak0.width");
  drag(width, {width.x - 50, width.y});
  EXPECT_NEAR(tf().points[3].value - tf().points[1].value, 50 * std::pow(1.02, -50), 0.5);
}

TEST_F(Panels, ThePeakUnderTheMouseIsLit) {
  EXPECT_FALSE(requests.lit_points);
  move_to(center_of("peak0"));
  frames(2);
  EXPECT_EQ(requests.lit_points, (std::pair<std::size_t, std::size_t>{2, 2}));
  move_to(center_of("view0"));
  EXPECT_FALSE(requests.lit_points);
}

TEST_F(Panels, AWidthThatIsDraggedToNothingAndBackKeepsItsShape) {
  tf().points = points_of({{0, 0}, {40, 0}, {50, 0.9}, {52, 0}, {100, 0}});
  frames(3);
  const ImVec2 place = center_of("##peak0.width");
  move_to(place);
  frames(2);
  press();
  frame();
  for (const float shift : {-200.0F, -1500.0F}) {
    move_to({place.x + shift, place.y});
    frame();
  }
  EXPECT_EQ(tf().points[3].value, tf().points[1].value) << "no width";
  move_to({place.x + 4, place.y});
  frame();
  release();
  frame();
  const double left = tf().points[2].value - tf().points[1].value,
               right = tf().points[3].value - tf().points[2].value;
  EXPECT_NEAR(left / right, 5, 1e-9);
  EXPECT_GT(left + right, 12);
}

TEST_F(Panels, AClickInTheListSelectsThePoint) {
  state->editor.selection = {0};
  const auto& [low, high] = state->widgets.items.at("peak0");
  click(ImVec2{low.x + 6, (low.y + high.y) / 2});
  EXPECT_EQ(state->editor.selection, Selection{2});
}

TEST_F(Panels, AllPointsAreEditedInATable) {
  click("tab/Points");
  type("##point2.value", "45.5");
  EXPECT_EQ(tf().points[2].value, 45.5);
  EXPECT_EQ(tf().points[1].value, 20) << "each point alone";
  type("##point1.opacity", "1/8");
  EXPECT_EQ(tf().points[1].opacity, 0.125);
  type("##point1.value", "80");
  EXPECT_EQ(tf().points[3].value, 80) << "in its new place";
  click("##point0.surface");
  click("##point0.surface/on");
  EXPECT_EQ(tf().points[0].surface.mode, SurfaceMode::on);
  click("row/point/1");
  ImGui::GetIO().KeyShift = true;
  click("row/point/3");
  ImGui::GetIO().KeyShift = false;
  EXPECT_EQ(state->editor.selection, (Selection{1, 2, 3}));
  ImGui::GetIO().KeyCtrl = true;
  click("row/point/2");
  ImGui::GetIO().KeyCtrl = false;
  EXPECT_EQ(state->editor.selection, (Selection{1, 3}));
}

TEST_F(Panels, WhatIsTypedInARowThatIsScrolledAwayIsNotLost) {
  tf().points.clear();
  for (int i = 0; i < 200; ++i) tf().points.push_back(points_of({{double(i), 0.1}})[0]);
  click("tab/Points");
  click("##point1.opacity");
  ctrl('A');
  for (const char c : {'.', '5'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(2);
  for (int i = 0; i < 20; ++i) wheel(-5);
  EXPECT_TRUE(has("##point150.opacity"));
  EXPECT_EQ(tf().points[1].opacity, 0.1);
  click(place_of(5));
  EXPECT_EQ(tf().points[1].opacity, 0.5);
}

TEST_F(Panels, ThePeakTableTellsItsCells) {
  const auto [low, high] = state->widgets.items.at("peak table");
  move_to({low.x + 2, low.y + 2});
  frame();
  EXPECT_NE(state->under_cursor.find("entry 0 .. 0.78125"), std::string::npos) << state->under_cursor;
  EXPECT_NE(state->under_cursor.find("exit 99.2188 .. 100"), std::string::npos) << state->under_cursor;
}

TEST_F(Panels, RenderingFieldsKeepTheirRanges) {
  ImGui::GetIO().DisplaySize = {1720, 1300};  // so that nothing has to be scrolled
  frames(3);
  click("tab/Rendering");
  Rendering& rendering = document.preset.rendering;
  type("##step", "0.125");
  EXPECT_EQ(rendering.step, 0.125);
  type("##step", "-3");
  EXPECT_EQ(rendering.step, 0.125);
  type("##step", "1/4");
  EXPECT_EQ(rendering.step, 0.25);
  type("##max peaks", "1000");
  EXPECT_EQ(rendering.max_peaks, 4);
  type("##max peaks", "2.5");
  EXPECT_EQ(rendering.max_peaks, 4);
  EXPECT_EQ(state->widgets.refused->why, "2.5 is not a whole number");
  type("##max peaks", "64");
  EXPECT_EQ(rendering.max_peaks, 64);
  type("##peak bins", "16");
  EXPECT_EQ(rendering.peak_bins, 16);
  click("##peak form");
  click("##peak form/paper");
  EXPECT_EQ(rendering.peak_form, PeakForm::paper);
  click("##shading");
  click("##shading/gradient");
  EXPECT_EQ(rendering.shading, Shading::gradient);
  click("##mode");
  click("##mode/PEAK_XOR_DVR");
  EXPECT_EQ(rendering.mode, Mode::peak_xor_dvr);
}

TEST_F(Panels, TheEngineBringsItsOwnRows) {
  click("tab/Rendering");
  Rendering& rendering = document.preset.rendering;
  EXPECT_FALSE(has("##layers per pass"));
  click("##engine");
  click("##engine/vdls");
  EXPECT_EQ(rendering.engine, Engine::vdls);
  frame();
  type("##layers per pass", "64");
  EXPECT_EQ(rendering.vdls.layers_per_pass, 64);
  click("##early test");
  EXPECT_FALSE(rendering.vdls.early_test);
}

// The pre-integration table holds one step length: what is chosen last prevails.
TEST_F(Panels, TheClassificationTakesItsPlacement) {
  click("tab/Rendering");
  Rendering& rendering = document.preset.rendering;
  rendering.adaptive = true;
  click("##classification");
  click("##classification/preintegrated_table");
  EXPECT_EQ(rendering.classification, ClassificationMethod::preintegrated_table);
  EXPECT_EQ(rendering.placement, Placement::entry);
  EXPECT_FALSE(rendering.adaptive);
  type("##preintegration bins", "2048");
  EXPECT_EQ(rendering.preintegration_bins, 2048);
  click("##placement");
  click("##placement/eye");
  EXPECT_EQ(rendering.placement, Placement::eye);
  EXPECT_EQ(rendering.classification, ClassificationMethod::preintegrated);
}

TEST_F(Panels, TheFiltersAreChosen) {
  click("tab/Rendering");
  Rendering& rendering = document.preset.rendering;
  for (const auto& [filter, name] : names_of<Filter>()) {
    click("##filter");
    click("##filter/" + std::string(name));
    EXPECT_EQ(rendering.filter, filter);
    EXPECT_EQ(rendering.root_filter, std::nullopt);
    frame();
    EXPECT_EQ(has("##bc b"), filter == Filter::bc) << "B and C only where a filter has them";
  }
  type("##bc b", "2");
  type("##bc c", "11");
  EXPECT_EQ(state->widgets.refused->why, "11 is not in [-10, 10]");
  type("##bc c", "10");
  EXPECT_EQ(rendering.bc_b, 2);
  EXPECT_EQ(rendering.bc_c, 10);
  click("##root filter");
  click("##root filter/linear_exact");
  EXPECT_EQ(rendering.root_filter, Filter::linear_exact);
  click("##root filter");
  click("##root filter/same");
  EXPECT_EQ(rendering.root_filter, std::nullopt);
}

TEST_F(Panels, TheGradientIsChosenWhereThereIsShading) {
  click("tab/Rendering");
  EXPECT_FALSE(has("##gradient"));
  document.preset.rendering.shading = Shading::gradient;
  frame();
  click("##gradient");
  click("##gradient/filter");
  EXPECT_EQ(document.preset.rendering.gradient, Gradient::filter);
}

TEST_F(Panels, ThePlacementIsChosen) {
  click("tab/Rendering");
  for (const auto& [placement, name] : names_of<Placement>()) {
    click("##placement");
    click("##placement/" + std::string(name));
    EXPECT_EQ(document.preset.rendering.placement, placement);
  }
}

TEST_F(Panels, TheClipBoxIsMadeMovedAndTakenAway) {
  ImGui::GetIO().DisplaySize = {1720, 1300};  // so that nothing has to be scrolled
  frames(3);
  click("tab/Rendering");
  const std::optional<ClipBox>& clip = document.preset.rendering.clip_box;
  EXPECT_FALSE(has("##clip min x"));
  click("##clip box");
  ASSERT_TRUE(clip);
  EXPECT_EQ(*clip, (ClipBox{volume.grid.box_min(), volume.grid.box_max(), ""}));
  frame();

  const auto [low, high] = state->widgets.items.at("##clip max y");
  const float middle = (low.y + high.y) / 2;
  drag({high.x - 8, middle}, {(low.x + high.x) / 2, middle});
  EXPECT_NEAR(clip->max.y, 5.5, 0.2) << "half of 0 .. 11";
  EXPECT_EQ(clip->min, volume.grid.box_min());
  EXPECT_EQ(clip->max.x, 11);
  ctrl('Z');
  EXPECT_EQ(clip->max.y, 11) << "a drag is one step";

  // One plane takes the other one with it, and they never meet
  const auto [left, right] = state->widgets.items.at("##clip min z");
  const auto [z_left, z_right] = state->widgets.items.at("##clip max z");
  const float z_middle = (z_left.y + z_right.y) / 2;
  drag({z_right.x - 8, z_middle}, {z_left.x - 400, z_middle});
  EXPECT_EQ(clip->min.z, 0);
  EXPECT_NEAR(clip->max.z, 0.011, 1e-9);
  drag({left.x + 8, z_middle}, {right.x + 400, z_middle});
  EXPECT_NEAR(clip->min.z, 11 - 0.011, 1e-9);
  EXPECT_EQ(clip->max.z, 11);

  click("##clip box");
  EXPECT_FALSE(clip);
  frame();
  EXPECT_FALSE(has("##clip min x"));
}

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

TEST_F(Hostile, NoVolume) {
  inputs.volume = nullptr;
  document.preset.rendering.clip_box = ClipBox{};
  frames(3);
  click("tab/Rendering");
  click("##clip box");
  EXPECT_FALSE(document.preset.rendering.clip_box);
  frame();
  EXPECT_FALSE(has("##clip box"));
  drag(place_of(2), {place_of(2).x + 20, place_of(2).y});
  EXPECT_GT(tf().points[2].value, 50);
  const ImVec2 middle = center_of("view0");
  drag(middle, {middle.x + 50, middle.y});
  EXPECT_FALSE(document.preset.camera);
}

TEST_F(Hostile, NoPoints) {
  tf().points.clear();
  frames(3);
  EXPECT_EQ(visible(), axis_range(tf(), &volume));
  key_of(ImGuiKey_Delete);
  ctrl('A');
  double_click(place_of(30, 0.5));
  EXPECT_EQ(tf().points.size(), 1U);
}

TEST_F(Hostile, StatisticsThatAreNoNumbers) {
  volume.statistics.range = {std::nan(""), std::nan("")};
  ImGui::NewFrame();
  StudioInputs strange = inputs;
  Camera nowhere;
  nowhere.eye = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
  document.preset.camera = nowhere;
  studio_frame(document, *state, strange);
  ImGui::Render();
  EXPECT_TRUE(std::isfinite(axis_range(tf(), &volume).width()));
}

TEST_F(Hostile, AConstantVolume) {
  volume.values.assign(volume.values.size(), 7);
  volume.statistics = compute_statistics(volume.grid, volume.values);
  tf().points = points_of({{7, 0}, {7, 1}});
  frames(5);
  move_to(place_of(7, 0.5));
  for (int i = 0; i < 200; ++i) wheel(5);
  frames(5);
  EXPECT_GT(visible().width(), 0);
  drag(place_of(1), {place_of(1).x + 20, place_of(1).y});
  EXPECT_GE(tf().points[1].value, tf().points[0].value);
}

TEST_F(Hostile, AThousandPoints) {
  tf().points.clear();
  for (int i = 0; i < 1000; ++i) {
    ControlPoint point;
    point.value = i / 10.0;
    point.opacity = i % 2 == 0 ? 0.1 : 0.9;
    tf().points.push_back(point);
  }
  document.preset.rendering.peak_bins = 32;
  frames(3);
  EXPECT_EQ(inputs.peaks.size(), 499U);
  EXPECT_LT(ImGui::GetDrawData()->TotalVtxCount, 60000);
  move_to(place_of(50, 0.5));
  ctrl('A');
  EXPECT_EQ(state->editor.selection.size(), 1000U);
  key_of(ImGuiKey_Delete);
  EXPECT_TRUE(tf().points.empty());
  frames(2);
  ctrl('Z');
  EXPECT_EQ(tf().points.size(), 1000U);
}

TEST_F(Hostile, WindowsOfAnySize) {
  for (const ImVec2 size :
       {ImVec2{0, 0}, {1, 1}, {70, 70}, {300, 100}, {100, 900}, {1000, 700}, {4000, 300}}) {
    ImGui::GetIO().DisplaySize = size;
    frames(3);
    for (const glm::ivec2 pixels : requests.view_pixels) {
      EXPECT_GE(pixels.x, 0);
      EXPECT_LE(pixels.x, std::max(int(size.x), 0));
      EXPECT_LE(pixels.y, std::max(int(size.y), 0));
    }
  }
}

TEST_F(Hostile, PeaksOfADocumentThatIsGone) {
  state->editor.selection = {3, 4};
  const std::vector<Peak> stale(inputs.peaks.begin(), inputs.peaks.end());
  StudioInputs old = inputs;
  old.peaks = stale;
  tf().points = points_of({{1, 0.5}});
  ImGui::NewFrame();
  studio_frame(document, *state, old);
  ImGui::Render();
  EXPECT_TRUE(state->editor.selection.empty());
}

}  // namespace
}  // namespace crest::test
