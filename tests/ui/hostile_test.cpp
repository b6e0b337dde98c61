#include <cmath>
#include <limits>

#include "tests/ui/harness.h"
#include "ui/transfer_function_editor.h"

namespace crest::test {
namespace {

/// Documents, volumes and windows of odd kinds.
using Hostile = Studio;

TEST_F(Hostile, NoVolume) {
  inputs.volume = nullptr;
  document.preset.rendering.clip_box = ClipBox{};
  frames(3);
  click("tab/Rendering");
  click("##clip box");
  EXPECT_FALSE(document.preset.rendering.clip_box);
  frame();
  click("##clip box");
  EXPECT_FALSE(document.preset.rendering.clip_box) << "greyed: of what would it be";
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
  volume.values.floats().assign(volume.values.size(), 7);
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
