#include "tests/ui/harness.h"
#include "ui/arrange_points.h"

namespace crest::test {
namespace {

using Tools = Studio;

TEST_F(Tools, ADragSnapsToOtherPointsAndMarksUnlessAltIsHeld) {
  inputs.volume = nullptr;  // and so no histogram
  tf().points = points_of({{0, 0}, {33.3, 0.2}, {60, 0.5}, {100, 0.5}});
  frames(2);
  const auto to = [&](double value) { return ImVec2{place_of(value, 0.5).x, place_of(2).y}; };
  drag(place_of(2), to(33.3 + 3 * pixel_value()));
  EXPECT_EQ(tf().points[2].value, 33.3);
  drag(place_of(2), to(40 - 3 * pixel_value()));
  EXPECT_EQ(tf().points[2].value, 40) << "a mark of the axis";
  ImGui::GetIO().KeyAlt = true;
  drag(place_of(2), to(33.3 + 3 * pixel_value()));
  EXPECT_NEAR(tf().points[2].value, 33.3 + 3 * pixel_value(), pixel_value());
  EXPECT_NE(tf().points[2].value, 33.3);
}

TEST_F(Tools, TheBarShiftsAndItsEndsStretch) {
  state->editor.snap = false;
  const double step = pixel_value();
  const auto by = [](ImVec2 place, float x) { return ImVec2{place.x + x, place.y}; };
  drag(center_of("span/high"), by(center_of("span/high"), -200));
  EXPECT_NEAR(tf().points[4].value, 100 - 200 * step, step);
  EXPECT_NEAR(tf().points[2].value, tf().points[4].value / 2, 1e-9);
  EXPECT_EQ(tf().points[0].value, 0);
  ctrl('Z');
  EXPECT_EQ(tf().points[2].value, 50);
  const ImVec2 middle = by(center_of("span/low"), 100);
  drag(middle, by(middle, 40));
  EXPECT_NEAR(tf().points[0].value, 40 * step, step);
  EXPECT_NEAR(tf().points[4].value - tf().points[0].value, 100, 1e-9);
  ctrl('Z');
  state->editor.selection = {1, 2, 3};
  frames(2);
  drag(center_of("span/low"), by(center_of("span/low"), 50));
  EXPECT_NEAR(tf().points[1].value, 20 + 50 * step, step) << "of the selected points alone";
  EXPECT_EQ(tf().points[3].value, 70);
  EXPECT_EQ(tf().points[0].value, 0);
}

TEST_F(Tools, ShapesAreAddedFromTheMenuAndTheirValueTyped) {
  for (const char* shape : {"Spike", "Tent", "Box", "Gaussian", "Ramp", "Step"}) {
    const std::size_t before = tf().points.size();
    click("shapes");
    click(shape);
    EXPECT_GE(tf().points.size(), before + (std::string_view(shape) == "Step" ? 2 : 1)) << shape;
    EXPECT_TRUE(ImGui::GetIO().WantTextInput) << shape;
    ctrl('Z');
    frames(2);
    EXPECT_EQ(tf().points.size(), before) << shape;
  }
  click("shapes");
  click("Gaussian");
  for (const char c : {'3', '0'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(2);
  key_of(ImGuiKey_Enter);
  frames(2);
  EXPECT_EQ(evaluate(tf(), 30).opacity, 0.8) << "the top is where its value was typed";
}

TEST_F(Tools, KeysAddASpikeAndAStep) {
  key('P');
  frames(2);
  EXPECT_EQ(inputs.peaks.size(), 2U);
  key_of(ImGuiKey_Escape);
  frames(2);
  key('S');
  EXPECT_EQ(tf().points.size(), 10U);
}

TEST_F(Tools, PointsAreCopiedCutAndPasted) {
  const auto original = tf().points;
  state->editor.selection = {1, 2};
  frames(2);
  ctrl('X');
  EXPECT_EQ(tf().points.size(), 3U);
  EXPECT_NE(std::string_view(ImGui::GetClipboardText()).find("\"opacity\": 0.8"), std::string_view::npos);
  ctrl('V');
  EXPECT_EQ(tf().points, original);
  EXPECT_EQ(state->editor.selection, (Selection{1, 2}));
  frames(2);
  key_of(ImGuiKey_Escape);
  frames(2);
  ctrl('V');
  EXPECT_EQ(tf().points.size(), 7U);
  EXPECT_EQ(tf().points[2].value, 20 + visible().width() * 0.02) << "beside those that are there";
  frames(2);
  key_of(ImGuiKey_Escape);
  frames(2);
  ImGui::SetClipboardText("no points");
  ctrl('V');
  EXPECT_EQ(tf().points.size(), 7U);
  EXPECT_NE(state->editor.note.find("holds no points"), std::string::npos);
}

TEST_F(Tools, TheMenuArrangesWhatIsSelected) {
  state->editor.selection = {1, 2, 3};
  frames(2);
  click("points");
  click("Mirror");
  EXPECT_EQ(tf().points, points_of({{0, 0}, {20, 0.1}, {40, 0.8}, {70, 0.2}, {100, 0.5}}));
  click("points");
  click("Distribute values");
  EXPECT_EQ(tf().points[2].value, 45);
  click("points");
  type("##opacity factor", "1/2");
  EXPECT_EQ(tf().points[2].opacity, 0.4);
  EXPECT_EQ(tf().points[4].opacity, 0.5);
}

TEST_F(Tools, NeighboursArePassedStoppedAtOrPushed) {
  click("points");
  click("Push their neighbours");
  EXPECT_EQ(state->editor.neighbours, Neighbours::push);
  state->editor.selection = {1};
  frames(2);
  type("##value", "60");
  EXPECT_EQ(tf().points[1].value, 60);
  EXPECT_EQ(tf().points[2].value, 60);
  EXPECT_EQ(tf().points[3].value, 70);
}

}  // namespace
}  // namespace crest::test
