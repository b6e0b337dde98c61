#include <fmt/core.h>

#include <filesystem>

#include "presets/preset_file.h"
#include "tests/ui/harness.h"
#include "ui/actions.h"

namespace crest::test {
namespace {

/// What the views show, and two pictures beside each other.
class Compare : public Studio {
 protected:
  Compare() {
    for (std::size_t i = 0; i < picture_count; ++i) inputs.views[i].texture = 100 + i;
    frames(2);
  }
  void choose(const std::string& menu, const std::string& entry) {
    click(menu);
    frames(2);
    click(entry);
    frames(2);
  }
  const Comparison& asked() const { return *requests.comparison; }
};

TEST_F(Compare, AViewShowsAnotherMode) {
  choose("content0", fmt::format("show/{}", name_of(Mode::both)));
  EXPECT_EQ(requests.contents[0].mode, Mode::both);
  EXPECT_EQ(requests.contents[1].mode, Mode::peak_only);
  EXPECT_EQ(document.preset.rendering.mode, Preset{}.rendering.mode) << "the preset's stays";
}

TEST_F(Compare, AViewHasAnEngineAndAPresetOfItsOwn) {
  click("content0");
  frames(2);
  click("Engine");
  frames(2);
  click("View-dependent layers (VDLS)");
  frames(2);
  EXPECT_EQ(requests.contents[0].engine, Engine::vdls);
  EXPECT_EQ(preset_of(requests.contents[0], document.preset).rendering.engine, Engine::vdls);
  EXPECT_EQ(preset_of(requests.contents[1], document.preset).rendering.engine, Engine::raycaster);
  click("content1");
  frames(2);
  click("Preset");
  frames(2);
  click("other/onion");
  frames(2);
  ASSERT_TRUE(requests.contents[1].other);
  EXPECT_EQ(preset_of(requests.contents[1], document.preset).name, requests.contents[1].other->preset.name);
  EXPECT_EQ(preset_of(requests.contents[1], document.preset).rendering.mode, Mode::peak_only);
}

TEST_F(Compare, ALineIsDraggedAndTheCameraStays) {
  choose("compare0", "with view2");
  ASSERT_TRUE(requests.comparison);
  EXPECT_EQ(asked().view, 0);
  EXPECT_EQ(asked().with, requests.contents[2]);
  const auto [low, high] = state->widgets.items.at("view0");
  const ImVec2 middle = center_of("view0");
  drag(middle, {middle.x + 100, middle.y});
  EXPECT_NEAR(asked().divider, 0.5 + 100 / (high.x - low.x), 0.01);
  EXPECT_FALSE(document.preset.camera);
  drag({middle.x - 100, middle.y}, {middle.x - 60, middle.y});
  EXPECT_NEAR(asked().divider, 0.5 + 100 / (high.x - low.x), 0.01) << "beside the line the camera turns";
  EXPECT_TRUE(document.preset.camera);
}

TEST_F(Compare, AViewThatIsComparedWithIsFollowed) {
  choose("compare0", "with view2");
  choose("content2", fmt::format("show/{}", name_of(Mode::peak_only)));
  EXPECT_EQ(asked().with.mode, Mode::peak_only);
  click("compare0");
  frames(2);
  click("with as set");  // of view 0 itself, which stays what it is
  frames(2);
  choose("content2", fmt::format("show/{}", name_of(Mode::both)));
  EXPECT_EQ(asked().with.mode, requests.contents[0].mode);
}

TEST_F(Compare, PresetsOfOnesOwnAndOfAnyFileCanBeShown) {
  const auto folder = std::filesystem::temp_directory_path() / "crest-compare-test";
  std::filesystem::create_directories(folder);
  Preset mine = document.preset;
  mine.name = "Mine";
  mine.transfer_function.points[0].opacity = 0.25;
  save_preset(folder / "mine.json", mine);
  const std::vector<LibraryEntry> entries{
      {(folder / "mine.json").string(), folder / "mine.json", "Mine", "", {}, 0}};
  inputs.library = entries;
  click("content1");
  frames(2);
  move_to(center_of("Preset"));
  bool reads = requests.reads_library;
  for (int i = 0; i < 30; ++i) reads |= frame().reads_library;
  EXPECT_TRUE(reads) << "the folder may have changed";
  click("other/" + entries[0].name);
  frames(2);
  ASSERT_TRUE(requests.contents[1].other);
  EXPECT_EQ(requests.contents[1].other->name, "Mine");
  EXPECT_EQ(requests.contents[1].other->preset.transfer_function.points[0].opacity, 0.25);

  click("compare0");
  frames(2);
  click("with preset");
  frames(2);
  click("other/file");
  frames(3);
  ASSERT_TRUE(has("file name"));
  for (const char c : (folder / "mine.json").string())
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(2);
  key_of(ImGuiKey_Enter);
  frames(2);
  ASSERT_TRUE(requests.comparison);
  EXPECT_EQ(asked().view, 0);
  EXPECT_EQ(asked().with.other->preset.name, "Mine");
  EXPECT_FALSE(requests.open_preset) << "what is edited stays";
  std::filesystem::remove_all(folder);
}

TEST_F(Compare, ASnapshotStaysAsItWas) {
  const Preset before = document.preset;
  choose("compare3", "with snapshot");
  ASSERT_TRUE(requests.comparison);
  tf().points[2].opacity = 0.123;
  frame();
  EXPECT_EQ(asked().view, 3);
  EXPECT_EQ(asked().with.other->preset, before);
  EXPECT_EQ(asked().with.mode, requests.contents[3].mode);
}

TEST_F(Compare, ASnapshotTakesThePlaceOfAViewThatWasFollowed) {
  const ActionContext context{document, *state, inputs, requests};
  action_named("Compare by the difference").run(context);
  frames(2);
  ASSERT_TRUE(asked().follows);
  action_named("Compare with a snapshot, taken now").run(context);
  const Preset before = document.preset;
  tf().points[2].opacity = 0.123;
  frames(3);
  EXPECT_EQ(asked().kind, ComparisonKind::difference);
  ASSERT_TRUE(asked().with.other);
  EXPECT_EQ(asked().with.other->preset, before);
}

TEST_F(Compare, NumbersStandUnderTheirOwnPictureAlone) {
  choose("compare0", "with view2");
  choose("compare0", "how/difference");
  key_of(ImGuiKey_Escape);  // the menu
  frames(2);
  EXPECT_TRUE(has("difference: The difference, when both are done"));
  inputs.difference = {200, 0.25, 0.5, 0.125, true, false};
  frames(2);
  EXPECT_TRUE(has("difference: RMSE 2.50e-01, at most 0.5, 12.50 % off by more than 1/255"));
  inputs.difference.is_measured = false;
  frames(2);
  EXPECT_TRUE(has("difference: Measuring ..."));
  inputs.difference.has_failed = true;
  frames(2);
  EXPECT_TRUE(has("difference: It could not be measured"));
}

TEST_F(Compare, BlinkingKeepsTheWindowGoingAndEscapeStopsIt) {
  click("compare1");
  frames(2);
  EXPECT_FALSE(has("with exact")) << "it is exact already";
  click("with as set");
  frames(2);
  EXPECT_EQ(asked().with.picture, ShownPicture::as_set);
  EXPECT_FALSE(requests.animates);
  choose("compare1", "how/blink");
  EXPECT_TRUE(requests.animates);
  key_of(ImGuiKey_Escape);  // the menu
  frames(2);
  EXPECT_TRUE(requests.animates);
  key_of(ImGuiKey_Escape);
  frames(2);
  EXPECT_FALSE(requests.comparison);
  EXPECT_FALSE(requests.animates);
}

TEST_F(Compare, OfAViewThatIsNotVisibleNothingIsAsked) {
  choose("compare1", "with view0");
  EXPECT_TRUE(requests.comparison);
  key('1');
  frame();
  EXPECT_FALSE(requests.comparison);
  key_of(ImGuiKey_Escape);  // brings the grid back, and with it the comparison
  frames(2);
  EXPECT_TRUE(requests.comparison);
}

TEST_F(Compare, KeysShowOneViewOrSoMany) {
  key('3');
  frame();
  EXPECT_EQ(state->views.enlarged, 2);
  key('3');
  frame();
  EXPECT_EQ(state->views.enlarged, -1);
  const int width = requests.view_pixels[0].x;
  ctrl('3');
  frame();
  EXPECT_EQ(requests.view_pixels[3].x, 0);
  EXPECT_EQ(requests.view_pixels[0].x, width);
  EXPECT_GT(requests.view_pixels[2].x, 1.9 * width) << "the last one has its row to itself";
  ctrl('1');
  frame();
  EXPECT_GT(requests.view_pixels[0].x, 1.9 * width);
  EXPECT_EQ(requests.view_pixels[1].x, 0);
}

TEST_F(Compare, TheMouseInOneViewIsMarkedInAllOthers) {
  const auto [low, high] = state->widgets.items.at("view1");
  move_to({low.x + (high.x - low.x) / 4, low.y + (high.y - low.y) / 2});
  frame();
  ASSERT_TRUE(state->views.cursor);
  EXPECT_NEAR(state->views.cursor->x, -0.25 * (high.x - low.x) / (high.y - low.y), 0.01);
  EXPECT_NEAR(state->views.cursor->y, 0.5, 0.01);
  move_to(place_of(50, 0.5));
  frame();
  EXPECT_FALSE(state->views.cursor);
}

}  // namespace
}  // namespace crest::test
