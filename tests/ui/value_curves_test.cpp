#include "ui/value_curves.h"

#include "tests/ui/harness.h"

namespace crest::test {
namespace {

class ValueCurves : public Studio {
 protected:
  ValueCurves() {
    by_value = *measure_by_value(volume, 64);
    inputs.by_value = &by_value;
    suggested = {{50.5, 3, 0.9}, {85, 2, 0.5}, {30, 1, 0.25}};
    inputs.suggested = suggested;
    frames(2);
  }
  void choose(const std::string& name) {
    click("##histogram");
    frames(2);
    click("##histogram/" + name);
    frames(2);
  }

  ByValue by_value;
  std::vector<SuggestedPeak> suggested;
};

TEST_F(ValueCurves, AClickOnAMarkAddsASpikeThereAndTheMarkGoes) {
  ASSERT_TRUE(has("suggestion/1"));
  EXPECT_FALSE(has("suggestion/0")) << "at 50 is a peak";
  const Document before = document;
  click("suggestion/1");
  frames(2);
  const std::vector<Peak> peaks = find_peaks(inputs.resolved);
  ASSERT_EQ(peaks.size(), 2U);
  EXPECT_NEAR(peaks[1].value, 85, pixel_value());
  EXPECT_EQ(peaks[1].opacity, 0.8);
  EXPECT_EQ(tf().points[state->editor.selection.at(0)].value, peaks[1].value);
  EXPECT_FALSE(has("suggestion/1"));
  EXPECT_TRUE(has("suggestion/2"));
  ctrl('Z');
  EXPECT_EQ(document, before);
  frames(2);
  EXPECT_TRUE(has("suggestion/1"));
}

TEST_F(ValueCurves, APointAtAMarkGoesFirst) {
  tf().points.insert(tf().points.begin() + 4, points_of({{85, 0.02}}).front());
  frames(2);
  const Document before = document;
  click("suggestion/1");
  EXPECT_EQ(document, before);
  EXPECT_EQ(state->editor.selection, Selection{4});
}

TEST_F(ValueCurves, MarksAreOfTheVolumesValuesAndCanBeHidden) {
  tf() = in_domain(tf(), Domain::normalized, volume.statistics.range);
  frames(2);
  EXPECT_NEAR(center_of("suggestion/1").x, place_of(0.85, 0).x, 1);
  click("suggestion/1");
  EXPECT_NEAR(tf().points[state->editor.selection.at(0)].value, 0.85, pixel_value());
  click("menu/View");
  frames(2);
  click("Suggested peaks");
  frames(2);
  EXPECT_FALSE(has("suggestion/2"));
}

TEST_F(ValueCurves, VisibilityIsAskedForWhileItIsToBeSeen) {
  EXPECT_FALSE(frame().show_visibility);
  choose("visibility");
  EXPECT_TRUE(requests.show_visibility);
  choose("area, log");
  EXPECT_FALSE(requests.show_visibility);
}

TEST_F(ValueCurves, TheStatusBarTellsWhatIsUnderTheMouse) {
  const auto told = [&](const char* curve) {
    choose(curve);
    move_to(place_of(60.2, 0.95));
    frame();
    return state->under_cursor;
  };
  const std::size_t bin = std::size_t(60.2 / 100 * 64);
  const auto ends_with = [](const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
  };
  char expected[80];
  std::snprintf(expected, sizeof expected, "surface area %.4g", surface_area(by_value)[bin]);
  EXPECT_PRED2(ends_with, told("area"), expected);
  std::snprintf(expected, sizeof expected, "mean gradient %.4g", mean_gradient(by_value)[bin]);
  EXPECT_PRED2(ends_with, told("gradient"), expected);
  std::snprintf(expected, sizeof expected, "volume above %.4g", enclosed_volume(by_value)[bin]);
  EXPECT_PRED2(ends_with, told("volume"), expected);
  Visibility visibility{{0, 100}, std::vector<double>(10, 0.01), std::vector<double>(10)};
  visibility.surface[6] = 0.3;
  inputs.visibility = &visibility;
  EXPECT_PRED2(ends_with, told("visibility"), "77.5 % of the picture");
}

constexpr ImU32 surface_column = IM_COL32(70, 112, 150, 255);

/// Whether something is drawn in the plot's columns, in a colour: how many vertices have it.
int vertices_of(ImU32 color) {
  int count = 0;
  const ImDrawData& drawn = *ImGui::GetDrawData();
  for (int i = 0; i < drawn.CmdListsCount; ++i)
    for (const ImDrawVert& vertex : drawn.CmdLists[i]->VtxBuffer) count += vertex.col == color ? 1 : 0;
  return count;
}

TEST_F(ValueCurves, EachIsDrawnOrSaysWhyNot) {
  Visibility visibility{{0, 100}, std::vector<double>(10, 0.01), std::vector<double>(10)};
  inputs.visibility = &visibility;
  visibility.surface[6] = 0.3;
  const char* const curves[] = {"values",    "values, log", "visibility", "visibility, log", "area",
                                "area, log", "gradient",    "volume",     "volume, log"};
  int expected = 1;  // in the order of the box
  for (const char* curve : curves) {
    choose(curve);
    EXPECT_EQ(int(state->editor.value_curve), expected++) << curve;
    EXPECT_GT(vertices_of(palette().histogram), 20) << curve;
    EXPECT_EQ(vertices_of(surface_column) > 0, is_visibility(state->editor.value_curve)) << curve;
  }
  choose("no curve");
  EXPECT_EQ(vertices_of(palette().histogram), 0);
  inputs.by_value = nullptr;
  choose("gradient");
  EXPECT_EQ(vertices_of(palette().histogram), 0);
  inputs.visibility = nullptr;
  choose("visibility");
  EXPECT_EQ(vertices_of(palette().histogram), 0);
}

TEST_F(ValueCurves, TheCurveOfTheLastVolumeIsCarriedOverFromTheMenu) {
  click("menu/Preset");
  frames(2);
  EXPECT_FALSE(has("menu/Carry over")) << "there was no other volume";
  key_of(ImGuiKey_Escape);
  inputs.carry_over = CarryOver{"tooth", true, true};
  const auto carry = [&](const std::string& how) {
    click("menu/Preset");
    frames(2);
    click("menu/Carry over");
    frames(2);
    move_to(center_of(how));
    press();
    release();
    const std::optional<CarryBy> carried = requests.carry;
    frames(2);
    key_of(ImGuiKey_Escape);
    key_of(ImGuiKey_Escape);
    frames(2);
    return carried;
  };
  EXPECT_EQ(carry("By histogram"), CarryBy::histogram);
  EXPECT_EQ(carry("By the same places"), CarryBy::places);
  EXPECT_EQ(carry("By range"), CarryBy::range);
  EXPECT_EQ(carry("As values"), CarryBy::value);
  inputs.carry_over->knows_values = false;
  EXPECT_EQ(carry("By histogram"), std::nullopt) << "their values are still being counted";
}

}  // namespace
}  // namespace crest::test
