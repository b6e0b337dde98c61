#include "tests/ui/harness.h"

namespace crest::test {
namespace {

class RenderingPanel : public Studio {
 protected:
  /// The tab with all of its groups, so high that nothing has to be scrolled.
  void open_all() {
    ImGui::GetIO().DisplaySize = {1720, 2600};
    frames(3);
    click("tab/Rendering");
    click("group/Advanced");
    frames(3);
  }
};

TEST_F(RenderingPanel, RenderingFieldsKeepTheirRanges) {
  open_all();
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

// What a choice greys or wakes keeps its place, so that nothing is under the mouse that was not there.
TEST_F(RenderingPanel, NoChoiceMovesAnother) {
  open_all();
  const auto places = state->widgets.items;
  Rendering& rendering = document.preset.rendering;
  const auto expect_same = [&](std::string_view after) {
    frames(3);
    for (const auto& [name, rect] : places) {
      if (!name.starts_with("##") && !name.starts_with("group/")) continue;
      ASSERT_TRUE(has(name)) << name << " after " << after;
      EXPECT_EQ(state->widgets.items[name].first.y, rect.first.y) << name << " after " << after;
      EXPECT_EQ(state->widgets.items[name].first.x, rect.first.x) << name << " after " << after;
    }
  };
  for (const auto& [engine, name] : names_of<Engine>()) rendering.engine = engine, expect_same(name);
  for (const auto& [filter, name] : names_of<Filter>()) rendering.filter = filter, expect_same(name);
  for (const auto& [shading, name] : names_of<Shading>()) rendering.shading = shading, expect_same(name);
  for (const auto& [sampling, name] : names_of<Sampling>()) rendering.sampling = sampling, expect_same(name);
  for (const auto& [method, name] : names_of<ClassificationMethod>())
    rendering.classification = method, expect_same(name);
  click("##clip box");
  EXPECT_TRUE(rendering.clip_box.has_value());
  expect_same("clip box");
}

TEST_F(RenderingPanel, AdvancedIsClosedAtFirst) {
  ImGui::GetIO().DisplaySize = {1720, 1160};
  click("tab/Rendering");
  for (const char* name : {"group/Quality", "group/Look", "group/Clip", "group/Advanced", "##step"})
    EXPECT_TRUE(has(name)) << name;
  EXPECT_FALSE(has("##engine"));
  click("group/Advanced");
  EXPECT_TRUE(has("##engine"));
}

TEST_F(RenderingPanel, TheEnginesOwnRowsWaitForIt) {
  open_all();
  Rendering& rendering = document.preset.rendering;
  click("##early test");
  EXPECT_TRUE(rendering.vdls.early_test) << "greyed";
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
  open_all();
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
  open_all();
  Rendering& rendering = document.preset.rendering;
  for (const auto& [filter, name] : names_of<Filter>()) {
    click("##filter");
    click("##filter/" + std::string(name));
    EXPECT_EQ(rendering.filter, filter);
    EXPECT_EQ(rendering.root_filter, std::nullopt);
    frame();
    const double before = rendering.bc_b;
    type("##bc b", "0.75");
    EXPECT_EQ(rendering.bc_b, filter == Filter::bc ? 0.75 : before) << "B and C only where a filter has them";
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
  open_all();
  click("##gradient");
  EXPECT_FALSE(has("##gradient/filter")) << "greyed";
  document.preset.rendering.shading = Shading::gradient;
  frame();
  click("##gradient");
  click("##gradient/filter");
  EXPECT_EQ(document.preset.rendering.gradient, Gradient::filter);
}

TEST_F(RenderingPanel, ThePlacementIsChosen) {
  open_all();
  for (const auto& [placement, name] : names_of<Placement>()) {
    click("##placement");
    click("##placement/" + std::string(name));
    EXPECT_EQ(document.preset.rendering.placement, placement);
  }
}

TEST_F(RenderingPanel, TheClipBoxIsMadeMovedAndTakenAway) {
  open_all();
  const std::optional<ClipBox>& clip = document.preset.rendering.clip_box;
  type("##clip min x", "3");
  EXPECT_FALSE(clip) << "greyed";
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
}

}  // namespace
}  // namespace crest::test
