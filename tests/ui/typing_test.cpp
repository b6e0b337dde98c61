#include "tests/ui/harness.h"

namespace crest::test {
namespace {

/// Numbers that are typed into the fields over the plot.
using Typing = Studio;

TEST_F(Typing, TypedNumbersAreExact) {
  click(place_of(4));
  type("##value", "50.123456789012345");
  EXPECT_EQ(tf().points[2].value, 50);
  EXPECT_EQ(tf().points[3].value, 50.123456789012345) << "it passed a point";
  EXPECT_EQ(state->editor.selection, Selection{3});
  type("##opacity", "1e-7");
  EXPECT_EQ(tf().points[3].opacity, 1e-7);
  ctrl('Z');
  EXPECT_EQ(tf().points[3].opacity, 0.5);
  EXPECT_EQ(tf().points[3].value, 50.123456789012345);
}

TEST_F(Typing, ATypedValueMovesThePeakAsAWhole) {
  click(place_of(2));
  type("##value", "60,5");
  ASSERT_EQ(inputs.peaks.size(), 1U);
  EXPECT_EQ(tf().points, points_of({{0, 0}, {30.5, 0.2}, {60.5, 0.8}, {80.5, 0.1}, {100, 0.5}}));
  type("##value", "-=1/2");
  EXPECT_EQ(tf().points[1].value, 30);
  EXPECT_EQ(tf().points[2].value, 60);
}

TEST_F(Typing, ASpikeOfNoWidthAndAStepGoWhereTheirValueIsTyped) {
  tf().points = points_of({{0, 0.1}, {30, 0.1}, {30, 0.9}, {30, 0.1}, {60, 0.1}, {60, 0.4}, {100, 0.4}});
  frames(2);
  click(place_of(2));
  type("##value", "45");
  for (const std::size_t i : {1U, 2U, 3U}) EXPECT_EQ(tf().points[i].value, 45);
  ASSERT_EQ(inputs.peaks.size(), 1U);
  EXPECT_TRUE(inputs.peaks[0].spike);
  click(place_of(5));
  type("##value", "20");
  EXPECT_EQ(tf().points,
            points_of({{0, 0.1}, {20, 0.1}, {20, 0.4}, {45, 0.4}, {45, 0.9}, {45, 0.4}, {100, 0.4}}))
      << "the step passed the spike, which kept its top; its feet stand on the curve";
}

TEST_F(Typing, ARefusedNumberStaysWithItsReason) {
  click(place_of(2));
  type("##opacity", "7");
  EXPECT_EQ(tf().points[2].opacity, 0.8);
  ASSERT_TRUE(has("##opacity/refused"));
  EXPECT_EQ(state->widgets.refused->why, "7 is not in [0, 1]");
  EXPECT_EQ(state->widgets.refused->text, "7");
  click("##opacity");
  key_of(ImGuiKey_Escape);
  frames(2);
  EXPECT_FALSE(has("##opacity/refused"));
  for (const char* wrong : {"abc", "nan", "1e999", "1/0", "1,000"}) {
    type("##value", wrong);
    EXPECT_EQ(tf().points[2].value, 50) << wrong;
    EXPECT_TRUE(has("##value/refused")) << wrong;
  }
  state->editor.neighbours = Neighbours::stop;
  click(place_of(3));
  EXPECT_FALSE(has("##value/refused")) << "it went with its point";
  type("##value", "1000");
  EXPECT_EQ(tf().points[3].value, 70);
  EXPECT_NE(state->widgets.refused->why.find("stops it at 100"), std::string::npos);
  type("##value", "1e2");
  EXPECT_EQ(tf().points[3].value, 100);
  EXPECT_FALSE(has("##value/refused"));
}

TEST_F(Typing, SavingAndQuittingTakeWhatIsTyped) {
  document.preset_path = "a.json";
  const auto start_typing = [&](char digit) {
    click(place_of(3));
    click("##value");
    ctrl('A');
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(digit));
    ImGui::GetIO().AddInputCharacter('1');
    frames(2);
  };
  start_typing('7');
  EXPECT_EQ(tf().points[3].value, 70);
  EXPECT_TRUE(ctrl('S').save_preset);
  EXPECT_EQ(tf().points[3].value, 71);
  start_typing('8');
  ImGui::GetIO().KeyCtrl = ImGui::GetIO().KeysDown[int('Q')] = true;
  EXPECT_FALSE(frame().quit) << "whether that is saved is known in the next frame";
  EXPECT_EQ(tf().points[3].value, 81);
  inputs.unsaved_changes = true;
  frames(2);
  EXPECT_TRUE(has("Discard")) << "the question is asked";
}

TEST_F(Typing, TabTakesWhatIsTypedAndGoesOn) {
  click(place_of(3));
  click("##value");
  ctrl('A');
  for (const char c : {'7', '2'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(2);
  key_of(ImGuiKey_Tab);
  frames(3);
  EXPECT_EQ(tf().points[3].value, 72);
  ctrl('A');
  for (const char c : {'.', '3'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(2);
  key_of(ImGuiKey_Enter);
  frames(2);
  EXPECT_EQ(tf().points[3].opacity, 0.3);
}

TEST_F(Typing, SeveralPointsShareTheFields) {
  state->editor.selection = {1, 3, 4};
  frames(2);
  type("##opacity", "*=1/2");
  EXPECT_EQ(tf().points[1].opacity, 0.1);
  EXPECT_EQ(tf().points[3].opacity, 0.05);
  EXPECT_EQ(tf().points[4].opacity, 0.25);
  type("##opacity", "0.4");
  for (const std::size_t i : {1U, 3U, 4U}) EXPECT_EQ(tf().points[i].opacity, 0.4);
  type("##opacity", "+=0.7");
  EXPECT_EQ(tf().points[1].opacity, 0.4);
  EXPECT_TRUE(has("##opacity/refused"));
  state->editor.selection = {3, 4};
  frames(2);
  type("##value", "60");
  EXPECT_EQ(tf().points[3].value, 60);
  EXPECT_EQ(tf().points[4].value, 90);
  type("##value", "+=,5");
  EXPECT_EQ(tf().points[3].value, 60.5);
  EXPECT_EQ(tf().points[4].value, 90.5);
}

TEST_F(Typing, WhatIsTypedIsTakenWhenTheFieldIsLeft) {
  click(place_of(2));
  click("##value");
  ctrl('A');
  for (const char c : {'5', '5', '.', '5'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(2);
  EXPECT_EQ(tf().points[2].value, 50) << "not before it is finished";
  click(place_of(4));
  EXPECT_EQ(tf().points[2].value, 55.5);
  EXPECT_EQ(tf().points[4].value, 100);
}

TEST_F(Typing, LookingAtANumberDoesNotChangeIt) {
  tf().points[2].value = 100.0 / 3 + 1e-13;
  const double value = tf().points[2].value;
  frames(2);
  click(place_of(2));
  click("##value");
  key_of(ImGuiKey_Enter);
  EXPECT_EQ(tf().points[2].value, value);
}

}  // namespace
}  // namespace crest::test
