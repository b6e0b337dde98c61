#include <fmt/core.h>

#include <algorithm>

#include "tests/ui/harness.h"

namespace crest::test {
namespace {

/// Picking in a view, and the panel of a ray.
class Ray : public Studio {
 protected:
  /// What the program would tell of the pixel under the mouse.
  void pick(std::optional<double> surface, std::optional<double> strongest) {
    inputs.picked = PickedPixel{*requests.hovered,
                                {surface, surface ? std::optional(2.5) : std::nullopt, strongest, 3, 0.4}};
    frame();
  }
  /// A ray that is clear up to a surface at depth 2.
  InspectedRay ray(bool finds_it) const {
    InspectedRay result;
    result.exact.enter = 1;
    result.exact.exit = 3;
    result.exact.places = {
        {1, 0, {}, 0, {}}, {2, 50, {}, 0, {}}, {2, 50, {}, 0.8, 50.0}, {3, 100, {}, 0.8, {}}};
    result.steps = {{1, {}, 0}, {1.5, {}, 0}, {2.5, glm::vec4(finds_it ? 0.8F : 0.1F), finds_it ? 1u : 0u}};
    result.crossings = check_crossings(result.exact, result.steps);
    return result;
  }
  bool says(const std::string& words) const {
    return std::ranges::any_of(state->widgets.items,
                               [&](const auto& item) { return item.first.find(words) != std::string::npos; });
  }
};

TEST_F(Ray, AClickInAViewAsksForIt) {
  const auto [low, high] = state->widgets.items.at("view2");
  const ImVec2 place{low.x + 30, low.y + 40};
  click(place);
  frame();
  ASSERT_TRUE(requests.inspect);
  EXPECT_EQ(requests.inspect->view, 2);
  EXPECT_EQ(requests.inspect->pixel, glm::ivec2(30, 40));
  EXPECT_EQ(requests.inspect->size, requests.view_pixels[2]);
  EXPECT_EQ(state->ray.mode, Mode::peak_xor_dvr);
  EXPECT_FALSE(document.preset.camera);
  frames(2);
  EXPECT_TRUE(has("ray mode/PEAK_ONLY")) << "its tab is open";
}

TEST_F(Ray, ADragTurnsAndAsksForNothing) {
  const ImVec2 middle = center_of("view0");
  drag(middle, {middle.x + 50, middle.y});
  frame();
  EXPECT_FALSE(requests.inspect);
  EXPECT_TRUE(document.preset.camera);
}

TEST_F(Ray, TellsWhatWasMissed) {
  RayInspection inspection;
  inspection.modes[2] = ray(false);
  inspection.modes[1] = ray(true);
  inputs.ray = &inspection;
  click(center_of("view2"));
  frames(3);
  EXPECT_TRUE(says("ray: Opacity 0.1, exact 0.8. 2 samples; of 1 crossings 1 missed"));
  click("ray mode/PEAK_ONLY");
  frames(2);
  EXPECT_TRUE(says("ray: Opacity 0.8, exact 0.8. 2 samples; of 1 crossings 0 missed"));
  click("ray mode/DVR_ONLY");
  frames(2);
  EXPECT_FALSE(has("ray plots")) << "not there yet";
  click("close ray");
  frames(2);
  EXPECT_FALSE(requests.inspect);
  inputs.ray = nullptr;
}

TEST_F(Ray, TellsWhyThereIsNone) {
  RayInspection inspection;
  inputs.ray = &inspection;
  click(center_of("view2"));
  frames(3);
  EXPECT_TRUE(has("ray: Solving the ray ..."));
  inspection.errors[2] = "no room";
  frames(2);
  EXPECT_TRUE(has("ray: The ray could not be solved: no room"));
  inputs.ray = nullptr;
}

TEST_F(Ray, TheDepthsAreZoomedAndPanned) {
  RayInspection inspection;
  inspection.modes[2] = ray(true);
  inputs.ray = &inspection;
  click(center_of("view2"));
  frames(3);
  const auto [low, high] = state->widgets.items.at("ray plots");
  move_to({(low.x + high.x) / 2, (low.y + high.y) / 2});
  frame();
  for (int i = 0; i < 5; ++i) wheel(1);
  ASSERT_TRUE(state->ray.visible);
  EXPECT_NEAR(state->ray.visible->width(), 2 * std::pow(0.8, 5), 1e-9);
  const double before = state->ray.visible->min;
  drag({(low.x + high.x) / 2, (low.y + high.y) / 2}, {(low.x + high.x) / 2 + 50, (low.y + high.y) / 2});
  EXPECT_LT(state->ray.visible->min, before);
  double_click({(low.x + high.x) / 2, (low.y + high.y) / 2});
  frame();
  EXPECT_FALSE(state->ray.visible);
  inputs.ray = nullptr;
}

TEST_F(Ray, APeakIsMadeOfWhatIsUnderTheMouse) {
  const std::size_t before = inputs.peaks.size();
  move_to(center_of("view1"));
  frame();
  ASSERT_TRUE(requests.hovered);
  EXPECT_EQ(requests.hovered->view, 1);
  pick({}, 30.0);
  EXPECT_NE(state->under_cursor.find("most from 30"), std::string::npos) << state->under_cursor;
  click(center_of("view1"), 1);
  frames(2);
  EXPECT_FALSE(has("select peak"));
  click("make peak");
  frames(2);
  ASSERT_EQ(inputs.peaks.size(), before + 1);
  EXPECT_TRUE(std::ranges::any_of(inputs.peaks, [](const Peak& peak) { return peak.value == 30; }));
  ctrl('Z');
  frame();
  EXPECT_EQ(inputs.peaks.size(), before);
}

TEST_F(Ray, TheSameValueIsOfferedOnce) {
  move_to(center_of("view1"));
  frame();
  pick(30.0, 30.00001);
  click(center_of("view1"), 1);
  frames(2);
  EXPECT_TRUE(has("select peak"));
  EXPECT_FALSE(has("make peak"));
  click("select peak");
  frame();
  EXPECT_EQ(state->editor.selection, Selection{2}) << "there is one peak";
  EXPECT_FALSE(requests.document_changed);
}

}  // namespace
}  // namespace crest::test
