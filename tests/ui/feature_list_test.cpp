#include "ui/feature_list.h"

#include "tests/ui/harness.h"

namespace crest::test {
namespace {

/// The list of what the pictures are made of, opened.
class FeatureListPanel : public Studio {
 protected:
  FeatureListPanel() {
    ImGui::GetIO().DisplaySize = {1720, 1600};  // so that nothing has to be scrolled
    PictureNeed& xor_view = inputs.views[2].need;
    xor_view.features.in = {"dvr", "peaks", "split"};
    xor_view.features.left_out = {{"peak_list", "there is one surface"},
                                  {"shading", "rendering.shading is none"},
                                  {"peak_table", "there is one surface"}};
    xor_view.features.notes = {"the transfer function has a step at 7"};
    xor_view.gpu_data = {{"volume", "12x12x12 points", 6912}, {"surfaces", "2", 64}};
    inputs.views[0].need.features.left_out = {{"peaks", "the mode is DVR_ONLY"}};
    document.preset.rendering.mode = Mode::peak_xor_dvr;
    frames(2);
    click("tab/Rendering");
    click("features");
  }
};

TEST_F(FeatureListPanel, TellsWhatIsInAndWhyTheRestIsNot) {
  const auto rows = feature_rows(inputs.views[2].need);
  const std::vector<std::tuple<std::string, std::string, bool>> expected{
      {"made of", "dvr, peaks, split", true},
      {"but", "the transfer function has a step at 7", true},
      {"volume", "12x12x12 points, 6.75 KiB", true},
      {"surfaces", "2, 64 bytes", true},
      {"left out", "peak_list, peak_table: there is one surface", false},
      {"left out", "shading: rendering.shading is none", false}};
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(std::tuple(rows[i].name, rows[i].text, rows[i].is_in), expected[i]);
    EXPECT_TRUE(has("row/" + rows[i].text)) << rows[i].text;
  }
}

TEST_F(FeatureListPanel, APictureOfNothingIsMadeOfNothing) {
  EXPECT_EQ(feature_rows(inputs.views[0].need)[0].text, "nothing");
}

TEST_F(FeatureListPanel, IsOfThePresetsModeUntilAnotherIsChosen) {
  EXPECT_TRUE(has("row/shading: rendering.shading is none"));
  click("listed/DVR_ONLY");
  EXPECT_FALSE(has("row/shading: rendering.shading is none"));
  EXPECT_TRUE(has("row/peaks: the mode is DVR_ONLY"));
  EXPECT_EQ(document.preset.rendering.mode, Mode::peak_xor_dvr) << "a look changes nothing";
}

// Of the views that are not drawn nothing is known.
TEST_F(FeatureListPanel, FollowsTheEnlargedView) {
  state->views.enlarged = 0;
  frame();
  EXPECT_TRUE(has("row/peaks: the mode is DVR_ONLY"));
  click("listed/PEAK_XOR_DVR");
  EXPECT_TRUE(has("row/peaks: the mode is DVR_ONLY"));
  state->views.enlarged = -1;
  frame();
  EXPECT_TRUE(has("row/shading: rendering.shading is none"));
}

TEST_F(FeatureListPanel, AViewThatWasNotDrawnHasNoRows) {
  click("listed/both");
  for (const auto& [name, place] : state->widgets.items) EXPECT_FALSE(name.starts_with("row/")) << name;
}

TEST_F(FeatureListPanel, Closes) {
  click("features");
  EXPECT_FALSE(has("listed/both"));
  EXPECT_FALSE(has("row/dvr, peaks, split"));
}

}  // namespace
}  // namespace crest::test
