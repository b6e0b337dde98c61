#include <cmath>

#include "tests/ui/harness.h"
#include "ui/transfer_function_editor.h"

namespace crest::test {
namespace {

using Editor = Studio;

ImVec2 moved_by(ImVec2 place, float x, float y) { return {place.x + x, place.y + y}; }

TEST_F(Editor, DraggingMovesAPointAndOneUndoTakesItBack) {
  state->editor.snap = false;
  const Document before = document;
  const double step = pixel_value();
  drag(place_of(2), moved_by(place_of(2), 40, 60));
  EXPECT_NEAR(tf().points[2].value, 50 + 40 * step, step);
  EXPECT_LT(tf().points[2].opacity, 0.8);
  EXPECT_EQ(tf().points[1], before.preset.transfer_function.points[1]);
  const Document after = document;
  EXPECT_TRUE(ctrl('Z').document_changed);
  EXPECT_EQ(document, before);
  ctrl('Z', true);
  EXPECT_EQ(document, after);
  ctrl('Z');
  ctrl('Y');
  EXPECT_EQ(document, after);
}

TEST_F(Editor, ADragStopsAtTheNeighbourWhereAsked) {
  state->editor.neighbours = Neighbours::stop;
  drag(place_of(2), moved_by(place_of(2), 400, 0));
  EXPECT_EQ(tf().points[2].value, 70);
  drag(moved_by(place_of(2), 0, 0), moved_by(place_of(2), -500, 0));
  EXPECT_EQ(tf().points[2].value, 20);
}

TEST_F(Editor, ShiftKeepsTheAxis) {
  ImGui::GetIO().KeyShift = true;
  drag(place_of(2), moved_by(place_of(2), 30, 9));
  EXPECT_EQ(tf().points[2].opacity, 0.8);
  EXPECT_GT(tf().points[2].value, 50);
  const double value = tf().points[2].value;
  drag(place_of(2), moved_by(place_of(2), 9, 50));
  EXPECT_EQ(tf().points[2].value, value);
  EXPECT_LT(tf().points[2].opacity, 0.8);
}

TEST_F(Editor, AClickSelectsAndMovesNothing) {
  const Document before = document;
  click(place_of(3));
  EXPECT_EQ(state->editor.selection, Selection{3});
  EXPECT_EQ(document, before);
  EXPECT_FALSE(state->history.can_undo(document));
  click(place_of(10, 0.9));
  EXPECT_TRUE(state->editor.selection.empty());
}

TEST_F(Editor, DoubleClickAddsAPointAtTheMouse) {
  double_click(place_of(35, 0.75));
  ASSERT_EQ(tf().points.size(), 6U);
  EXPECT_NEAR(tf().points[2].value, 35, pixel_value());
  EXPECT_NEAR(tf().points[2].opacity, 0.75, 0.01);
  EXPECT_EQ(state->editor.selection, Selection{2});
  frames(3);
  ctrl('Z');
  EXPECT_EQ(tf().points.size(), 5U);
}

TEST_F(Editor, DeleteRemovesTheSelected) {
  click(place_of(1));
  key_of(ImGuiKey_Delete);
  ASSERT_EQ(tf().points.size(), 4U);
  EXPECT_EQ(tf().points[1].value, 50);
  click(place_of(1));
  key_of(ImGuiKey_Backspace);
  EXPECT_EQ(tf().points.size(), 3U);
  ctrl('Z');
  ctrl('Z');
  EXPECT_EQ(tf().points.size(), 5U);
}

TEST_F(Editor, ArrowsNudgeByPixelsAndAHeldKeyIsOneStep) {
  click(place_of(2));
  const Document before = document;
  const double step = pixel_value();
  key_of(ImGuiKey_RightArrow);
  EXPECT_NEAR(tf().points[2].value, 50 + step, 0.02 * step);
  ctrl('Z');
  EXPECT_EQ(document, before);
  ImGui::GetIO().KeyShift = true;
  key_of(ImGuiKey_LeftArrow);
  ImGui::GetIO().KeyShift = false;
  EXPECT_NEAR(tf().points[2].value, 50 - 10 * step, 0.02 * step);
  key_of(ImGuiKey_UpArrow);
  EXPECT_GT(tf().points[2].opacity, 0.8);
  EXPECT_LT(tf().points[2].opacity, 0.81);
}

TEST_F(Editor, ABoxSelectsAndThePointsMoveTogether) {
  drag(place_of(15, 0.95), place_of(75, 0.05));
  EXPECT_EQ(state->editor.selection, (Selection{1, 2, 3}));
  drag(place_of(2), moved_by(place_of(2), 20, 0));
  EXPECT_NEAR(tf().points[3].value - tf().points[1].value, 50, 0.01);
  EXPECT_GT(tf().points[1].value, 20);
  ctrl('A');
  EXPECT_EQ(state->editor.selection.size(), 5U);
}

TEST_F(Editor, CtrlClickAddsToTheSelection) {
  click(place_of(1));
  ImGui::GetIO().KeyCtrl = true;
  click(place_of(3));
  EXPECT_EQ(state->editor.selection, (Selection{1, 3}));
  click(place_of(1));
  EXPECT_EQ(state->editor.selection, Selection{3});
}

TEST_F(Editor, WheelZoomsAboutTheMouseAndFitShowsAll) {
  const ImVec2 place = place_of(50, 0.4);
  const ImVec2 mouse{std::floor(place.x), std::floor(place.y)};  // as Dear ImGui takes it
  const double value = 50 - double(place.x - mouse.x) * pixel_value();
  move_to(mouse);
  for (int i = 0; i < 10; ++i) wheel(1);
  EXPECT_LT(visible().width(), 104 * std::pow(1.3, -9.9));
  EXPECT_NEAR(place_of(value, 0.4).x, mouse.x, 0.05);
  click("fit");
  EXPECT_FALSE(state->editor.visible);
}

TEST_F(Editor, ANarrowPeakCanBeDrawnAndDraggedZoomedIn) {
  state->editor.snap = false;
  tf().points = points_of({{0, 0}, {40 - 0.005, 0}, {40, 0.9}, {40 + 0.005, 0}, {100, 0}});
  state->editor.selection = {1, 2, 3};
  frames(2);
  key('F');
  frames(2);
  EXPECT_NEAR(visible().width(), 0.016, 1e-6);
  click(place_of(60, 0.5));  // far outside: nothing happens
  state->editor.selection.clear();
  const double step = pixel_value();
  drag(place_of(3), moved_by(place_of(3), 100, -30));
  EXPECT_NEAR(tf().points[3].value, 40.005 + 100 * step, step);
  EXPECT_GT(tf().points[3].opacity, 0);
  EXPECT_EQ(tf().points[2].value, 40);
}

TEST_F(Editor, TheDeepestZoomStillDrags) {
  tf().points = points_of({{0, 0}, {40, 0.5}, {100, 0}});
  frames(2);
  state->editor.visible = ValueRange{40 - 1e-10, 40 + 1e-10};
  frames(2);
  drag(place_of(1), moved_by(place_of(1), 50, 0));
  EXPECT_NEAR(tf().points[1].value - 40, 50 * pixel_value(), 2e-12);
  EXPECT_GT(tf().points[1].value, 40);
}

TEST_F(Editor, MiddleDragPansAndAxisDoubleClickFits) {
  move_to(place_of(50, 0.4));
  for (int i = 0; i < 5; ++i) wheel(1);
  const ValueRange before = visible();
  drag(place_of(50, 0.4), moved_by(place_of(50, 0.4), 30, 0), 2);
  EXPECT_NEAR(visible().min, before.min - 30 * pixel_value(), 1e-9);
  EXPECT_NEAR(visible().width(), before.width(), 1e-9);
  const auto& [low, high] = state->widgets.items.at("plot");
  double_click({(low.x + high.x) / 2, high.y + 16});
  EXPECT_FALSE(state->editor.visible);
}

TEST_F(Editor, TheLogarithmicAxisReachesSmallOpacities) {
  click("log opacity");
  EXPECT_TRUE(state->editor.opacity_axis.logarithmic);
  drag(place_of(2), place_of(50, 1e-5));
  EXPECT_NEAR(tf().points[2].opacity, 1e-5, 5e-7);
  EXPECT_NEAR(tf().points[2].value, 50, pixel_value());
}

TEST_F(Editor, AddPeakMakesASpikeOfTheTypedWidth) {
  type("##peak width", "0.02");
  click("add peak");
  ASSERT_EQ(tf().points.size(), 8U);
  const std::size_t apex = state->editor.selection.at(0);
  EXPECT_NEAR(tf().points[apex + 1].value - tf().points[apex - 1].value, 0.02, 1e-9);
  frame();
  EXPECT_TRUE(inputs.peaks[0].spike || inputs.peaks[1].spike);
}

TEST_F(Editor, APeakIsAddedAsASpikeAndItsValueTyped) {
  click("add peak");
  ASSERT_EQ(inputs.peaks.size(), 2U);
  EXPECT_TRUE(inputs.peaks[0].spike || inputs.peaks[1].spike);
  const auto enter = [&](std::string_view text) {
    for (const char c : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    frames(2);
  };
  enter("33");
  click("add peak");
  enter("90");
  key_of(ImGuiKey_Enter);
  frames(2);
  ASSERT_EQ(inputs.peaks.size(), 3U);
  EXPECT_EQ(inputs.peaks[0].value, 33);
  EXPECT_EQ(inputs.peaks[2].value, 90);
  for (const std::size_t i : {0U, 2U}) EXPECT_TRUE(inputs.peaks[i].spike);
  EXPECT_NEAR(evaluate(tf(), 89).opacity, 0.1 + 0.4 * 19 / 30, 1e-9) << "the curve beneath is as it was";
  const double values[] = {90, 33};
  for (const double value : values) {
    ctrl('Z');
    EXPECT_EQ(inputs.peaks.size(), value == 90 ? 3U : 2U) << "moved back";
    ctrl('Z');
    EXPECT_EQ(inputs.peaks.size(), value == 90 ? 2U : 1U) << "taken out";
  }
}

TEST_F(Editor, WhatIsTypedBeforeTheFieldIsOpenIsNotLost) {
  key('P');
  for (const char c : {'3', '3'}) {
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    frame();
  }
  frames(3);
  key_of(ImGuiKey_Enter);
  frames(2);
  ASSERT_EQ(inputs.peaks.size(), 2U);
  EXPECT_EQ(inputs.peaks[0].value, 33);
}

TEST_F(Editor, UndoTakesBackAPeakWhoseValueIsNotTypedYet) {
  const Document before = document;
  click("add peak");
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  ctrl('Z');
  frames(2);
  EXPECT_EQ(document, before);
}

TEST_F(Editor, TheMenuAddsAPeakUnderTheMouse) {
  click(place_of(30, 0.9), 1);
  click("Add peak");
  ASSERT_EQ(tf().points.size(), 8U);
  EXPECT_NEAR(tf().points[state->editor.selection.at(0)].value, 30, pixel_value());
}

TEST_F(Editor, TheMenuMakesStepsAndSurfaces) {
  click(place_of(3), 1);
  click("Surface: on");
  EXPECT_EQ(tf().points[3].surface.mode, SurfaceMode::on);
  click(place_of(3), 1);
  click("Make step");
  ASSERT_EQ(tf().points.size(), 6U);
  EXPECT_EQ(tf().points[3].value, tf().points[4].value);
  EXPECT_EQ(tf().points[3].opacity, 0.8);
  click(place_of(1), 1);
  click("Delete");
  EXPECT_EQ(tf().points.size(), 5U);
}

TEST_F(Editor, OfPointsAtOnePlaceTheOneGoesThatCan) {
  tf().points = points_of({{0, 0}, {50, 0}, {50, 0.9}, {50, 0}, {100, 0}});
  frames(2);
  drag(place_of(50, 0), moved_by(place_of(50, 0), -40, 0));
  EXPECT_LT(tf().points[1].value, 50);
  EXPECT_EQ(tf().points[3].value, 50);
}

TEST_F(Editor, NormalizedFunctionsAreShownOverTheUnitRange) {
  state->editor.snap = false;
  tf().domain = Domain::normalized;
  tf().points = points_of({{0, 0}, {0.5, 0.8}, {1, 0}});
  frames(3);
  EXPECT_NEAR(visible().width(), 1.04, 1e-9);
  const double step = pixel_value();
  drag(place_of(1), moved_by(place_of(1), 100, 0));
  EXPECT_NEAR(tf().points[1].value, 0.5 + 100 * step, step);
}

TEST_F(Editor, UnitDistanceAndPeakRule) {
  type("##unit distance", "2.5");
  EXPECT_EQ(tf().unit_distance, 2.5);
  type("##unit distance", "-3");
  EXPECT_EQ(tf().unit_distance, 2.5);
  EXPECT_EQ(state->widgets.refused->why, "-3 is not greater than 0");
  click("##unit");
  click("##unit/voxel");
  EXPECT_EQ(tf().unit, LengthUnit::voxel);
  click("peak rule");
  type("##spike width", "0.25");
  EXPECT_EQ(tf().spike_width, 0.25);
  type("##spike width", "7");
  EXPECT_EQ(tf().spike_width, 0.25) << "more than a file can hold";
  type("##min prominence", "0.125");
  EXPECT_EQ(tf().min_prominence, 0.125);
}

}  // namespace
}  // namespace crest::test
