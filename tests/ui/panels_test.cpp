#include <cmath>

#include "tests/ui/harness.h"

namespace crest::test {
namespace {

/// The lists of peaks and points, and the peak table.
using Panels = Studio;

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

TEST_F(Panels, TellThatPointsOfTheVolumeWereLeftOut) {
  EXPECT_FALSE(has("thinned note"));
  volume.part = whole_grid(glm::u64vec3(volume.grid.dims));
  volume.part->end.x -= 1;
  frames(2);
  EXPECT_FALSE(has("thinned note")) << "a box has all of its points";
  volume.part->stride.y = 2;
  frames(2);
  EXPECT_TRUE(has("thinned note"));
  EXPECT_TRUE(has("peak0.eye"));
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
  EXPECT_LT(state->widgets.items["peak table"].second.x - state->widgets.items["peak table"].first.x, 140);
  click("peak table");
  EXPECT_TRUE(state->settings.large_peak_table) << "small until it is asked for";
  frames(3);
  const auto [low, high] = state->widgets.items.at("peak table");
  move_to({low.x + 2, low.y + 2});
  frame();
  EXPECT_NE(state->under_cursor.find("entry 0 .. 0.78125"), std::string::npos) << state->under_cursor;
  EXPECT_NE(state->under_cursor.find("exit 99.2188 .. 100"), std::string::npos) << state->under_cursor;
}

}  // namespace
}  // namespace crest::test
