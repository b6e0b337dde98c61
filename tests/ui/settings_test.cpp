#include "tests/ui/harness.h"

namespace crest::test {
namespace {

using Settings = Studio;

TEST_F(Settings, ThemeAndScaleAreChosen) {
  click("menu/View");
  click("Settings...");
  ASSERT_TRUE(has("theme/light"));
  click("theme/light");
  EXPECT_EQ(state->settings.theme, Theme::light);
  click("##scale");
  click("scale/200 %");
  EXPECT_EQ(state->settings.scale, 2.0);
  click("##scale");
  click("scale/as the screen says");
  EXPECT_EQ(state->settings.scale, std::nullopt);
  click("theme/dark");
  EXPECT_EQ(state->settings.theme, Theme::dark);
  key_of(ImGuiKey_Escape);
  frame();
  EXPECT_FALSE(has("theme/dark"));
}

TEST_F(Settings, EscapeClosesTheListOfScalesAlone) {
  click("menu/View");
  click("Settings...");
  click("##scale");
  ASSERT_TRUE(has("scale/200 %"));
  key_of(ImGuiKey_Escape);
  frames(2);
  EXPECT_FALSE(has("scale/200 %"));
  EXPECT_TRUE(has("theme/dark"));
  key_of(ImGuiKey_Escape);
  frames(2);
  EXPECT_FALSE(has("theme/dark"));
}

using ErrorBanner = Studio;

TEST_F(ErrorBanner, EscThatClosesAMenuLeavesIt) {
  inputs.message = "It cannot be read.";
  inputs.message_is_error = true;
  click("menu/View");
  ASSERT_TRUE(has("Settings..."));
  EXPECT_FALSE(key_of(ImGuiKey_Escape).close_message);
  frames(2);
  EXPECT_FALSE(has("Settings..."));
  EXPECT_TRUE(key_of(ImGuiKey_Escape).close_message);
}

TEST_F(ErrorBanner, LiesOverTheViewsAndMovesNothing) {
  const auto items = state->widgets.items;
  inputs.message = "head.raw: its size is not known. Give it as head.raw?size=256x256x128.";
  inputs.message_is_error = true;
  frames(3);
  ASSERT_TRUE(has("error banner"));
  for (const auto& [name, rect] : items) {
    EXPECT_EQ(state->widgets.items[name].first.y, rect.first.y) << name;
    EXPECT_EQ(state->widgets.items[name].first.x, rect.first.x) << name;
  }
  const auto& [low, high] = state->widgets.items["error banner"];
  EXPECT_LT(high.x, state->widgets.items["plot"].first.x) << "over the views alone";
  EXPECT_GT(high.y - low.y, 20);
}

TEST_F(ErrorBanner, IsClosedByItsButtonAndByEsc) {
  inputs.message = "It cannot be read.";
  inputs.message_is_error = true;
  frames(3);
  EXPECT_TRUE(press_on("close error").close_message);
  state->editor.selection = {1};
  EXPECT_TRUE(key_of(ImGuiKey_Escape).close_message);
  EXPECT_EQ(state->editor.selection.size(), 1U) << "Esc does one thing";
  inputs.message.clear();
  frames(2);
  EXPECT_FALSE(has("error banner"));
  EXPECT_FALSE(key_of(ImGuiKey_Escape).close_message);
  EXPECT_TRUE(state->editor.selection.empty());
}

TEST_F(ErrorBanner, NewsIsNone) {
  inputs.message = "Saved";
  frames(3);
  EXPECT_FALSE(has("error banner"));
}

}  // namespace
}  // namespace crest::test
