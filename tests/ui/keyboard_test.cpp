#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <glm/geometric.hpp>

#include "render/scene/camera.h"
#include "tests/ui/harness.h"
#include "ui/keys.h"

namespace crest::test {
namespace {

/// The studio without a mouse.
class Keyboard : public Studio {
 protected:
  void write(std::string_view text) {
    for (const char c : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    frames(2);
  }
  StudioRequests press_key(int code, bool shift = false) {
    ImGui::GetIO().KeyShift = shift;
    const StudioRequests result = key(code);
    ImGui::GetIO().KeyShift = false;
    frames(2);
    return result;
  }
  void focus_plot() {
    press_key(key::f6);
    press_key(key::f6);
  }
  static bool is_shown() { return ImGui::GetIO().NavVisible; }
};

TEST_F(Keyboard, AMenuIsOpenedAndChosenFrom) {
  press_key(key::f10);
  ASSERT_TRUE(has("Close volume"));
  EXPECT_TRUE(is_shown());
  for (int i = 0; i < 3; ++i) press_key(key::down);
  EXPECT_TRUE(press_key(key::enter).close_volume);
  EXPECT_FALSE(has("Close volume"));
}

TEST_F(Keyboard, AltAloneOpensTheMenusAndEscapeClosesThem) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyAlt = true;
  frame();
  key(key::right);
  io.KeyAlt = false;
  frames(2);
  EXPECT_FALSE(has("Quit")) << "it was held with an arrow";
  io.KeyAlt = true;
  frame();
  io.KeyAlt = false;
  frames(3);
  EXPECT_TRUE(has("Quit"));
  state->editor.selection = {1};
  press_key(key::escape);
  EXPECT_FALSE(has("Quit"));
  EXPECT_EQ(state->editor.selection, Selection{1}) << "Esc does one thing";
}

TEST_F(Keyboard, RightLeadsToTheNextMenu) {
  press_key(key::f10);
  press_key(key::right);
  press_key(key::down);
  EXPECT_TRUE(has("Save as..."));
  EXPECT_FALSE(has("Quit"));
}

TEST_F(Keyboard, F6LeadsFromPartToPart) {
  press_key(key::f6);
  EXPECT_EQ(state->navigation.area, Area::views);
  EXPECT_TRUE(is_shown());
  press_key(key::f6);
  EXPECT_EQ(state->navigation.area, Area::editor);
  press_key(key::f6);
  EXPECT_EQ(state->navigation.area, Area::tabs);
  press_key(key::right);
  press_key(key::enter);
  EXPECT_TRUE(has("##point0.value")) << "the tab of the points is open";
  press_key(key::escape);
  EXPECT_FALSE(is_shown());
}

TEST_F(Keyboard, TabGoesToFieldsAndButtonsAndShowsWhere) {
  focus_plot();
  press_key(key::tab);
  EXPECT_FALSE(ImGui::GetIO().WantTextInput) << "the values of the axis: data, or 0 to 1";
  EXPECT_TRUE(is_shown());
  press_key(key::tab);
  press_key(key::tab);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput) << "the field for the unit distance";
  ctrl('A');
  write("3");
  press_key(key::tab);
  EXPECT_EQ(tf().unit_distance, 3);
  EXPECT_FALSE(ImGui::GetIO().WantTextInput) << "the choice of the unit";
  EXPECT_TRUE(is_shown());
  press_key(key::tab);
  const bool before = state->editor.peak_rule;
  press_key(key::enter);
  EXPECT_NE(state->editor.peak_rule, before) << "the arrow that shows the peak rule";
  press_key(' ');
  EXPECT_EQ(state->editor.peak_rule, before);
  press_key(key::tab, true);
  press_key(key::tab, true);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput) << "back";
}

TEST_F(Keyboard, ArrowsNudgeWhileThePlotOrNothingHasTheFocus) {
  state->editor.selection = {1};
  frame();
  const double before = tf().points[1].value;
  press_key(key::right);
  const double once = tf().points[1].value;
  EXPECT_GT(once, before);
  EXPECT_FALSE(is_shown());
  focus_plot();
  press_key(key::right);
  const double twice = tf().points[1].value;
  EXPECT_GT(twice, once);
  press_key(key::tab);  // a field
  press_key(key::tab);  // the choice beside it
  press_key(key::right);
  press_key(key::down);
  EXPECT_EQ(tf().points[1].value, twice);
  EXPECT_EQ(state->editor.selection, Selection{1});
}

TEST_F(Keyboard, TheFocusOnAViewTurnsMovesAndComesNearer) {
  const Camera start = camera_of(document.preset, volume.grid, aspect_of(requests.view_pixels[0]));
  press_key(key::f6);
  press_key(key::right);
  ASSERT_TRUE(document.preset.camera);
  EXPECT_NE(document.preset.camera->eye, start.eye);
  EXPECT_EQ(document.preset.camera->target, start.target);
  press_key(key::up, true);
  EXPECT_NE(document.preset.camera->target, start.target);
  const Camera far = *document.preset.camera;
  press_key(key::page_up);
  EXPECT_LT(glm::length(document.preset.camera->eye - far.target), glm::length(far.eye - far.target));
}

TEST_F(Keyboard, EnterConfirmsADialogAndTabLeadsToItsOtherButtons) {
  ctrl('P');
  frames(3);
  ASSERT_TRUE(has("picture file"));
  press_key(key::tab);
  press_key(key::enter);
  EXPECT_FALSE(has("picture file")) << "Cancel";
  EXPECT_FALSE(has("file name"));
  ctrl('P');
  frames(3);
  press_key(key::enter);
  EXPECT_TRUE(has("file name")) << "the button that is marked";
  press_key(key::escape);
  press_key(key::escape);
  EXPECT_FALSE(has("file name"));
}

TEST_F(Keyboard, EnterSavesBeforeQuitting) {
  inputs.unsaved_changes = true;
  document.preset_path = "/nowhere/mine.json";
  ctrl('Q');
  frames(3);
  ASSERT_TRUE(has("Stay"));
  const StudioRequests answer = press_key(key::enter);
  EXPECT_EQ(answer.save_preset, "/nowhere/mine.json");
  EXPECT_TRUE(answer.quit);
}

TEST_F(Keyboard, AWholeTask) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::canonical(fs::temp_directory_path()) / fmt::format("crest_keys_{}", ::getpid());
  fs::create_directories(folder);
  state->file_dialog.folder = folder;
  ctrl('P', true);
  write("open gyr");
  EXPECT_EQ(press_key(key::enter).open_volume, "builtin:gyroid");
  ImGui::GetIO().AddInputCharacter('p');
  key('P');
  write("33");
  press_key(key::enter);
  ASSERT_EQ(state->editor.selection.size(), 1u);
  EXPECT_EQ(tf().points[state->editor.selection[0]].value, 33);
  document.volume_source = "builtin:gyroid";
  ctrl('S');
  frames(2);
  ctrl('A');
  write("mine");
  EXPECT_EQ(press_key(key::enter).save_preset, folder / "mine.json");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace crest::test
