#include "tests/ui/harness.h"

namespace crest::test {
namespace {

using RenderingPanel = Studio;

TEST_F(RenderingPanel, RenderingFieldsKeepTheirRanges) {
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

TEST_F(RenderingPanel, TheEngineBringsItsOwnRows) {
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
TEST_F(RenderingPanel, TheClassificationTakesItsPlacement) {
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

TEST_F(RenderingPanel, TheFiltersAreChosen) {
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

TEST_F(RenderingPanel, TheGradientIsChosenWhereThereIsShading) {
  click("tab/Rendering");
  EXPECT_FALSE(has("##gradient"));
  document.preset.rendering.shading = Shading::gradient;
  frame();
  click("##gradient");
  click("##gradient/filter");
  EXPECT_EQ(document.preset.rendering.gradient, Gradient::filter);
}

TEST_F(RenderingPanel, ThePlacementIsChosen) {
  click("tab/Rendering");
  for (const auto& [placement, name] : names_of<Placement>()) {
    click("##placement");
    click("##placement/" + std::string(name));
    EXPECT_EQ(document.preset.rendering.placement, placement);
  }
}

TEST_F(RenderingPanel, TheClipBoxIsMadeMovedAndTakenAway) {
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

}  // namespace
}  // namespace crest::test
