#include "tests/ui/harness.h"

namespace crest::test {
namespace {

class PictureOf : public Studio {
 protected:
  PictureOf() {
    document.preset.transfer_function.points = points_of({{0, 0}, {40, 0.8}, {100, 0}});
    inputs.volume = &volume;
    frames(3);
  }
  void open_dialog() {
    ctrl('P');
    frames(3);
  }
  const PictureAsk& ask() const { return state->picture_dialog.ask; }
};

// Its picture has the plot's form; that of a view is as it was.
TEST_F(PictureOf, TheEditorHasASizeOfItsOwn) {
  open_dialog();
  ASSERT_EQ(ask().view, picture_of_grid);
  const glm::ivec2 view = ask().size;
  click("picture of/editor");
  EXPECT_EQ(ask().view, picture_of_editor);
  EXPECT_EQ(ask().size, state->picture_dialog.editor_as_shown);
  EXPECT_GT(ask().size.x, ask().size.y);
  frame();
  EXPECT_FALSE(has("##turntable")) << "it cannot be turned";
  type("##picture width", "2000");
  click("picture of/editor");
  EXPECT_EQ(ask().size.x, 2000) << "chosen once more, nothing changes";
  click("picture of/1");
  EXPECT_EQ(ask().view, 1);
  EXPECT_EQ(ask().size, view);
}

TEST_F(PictureOf, TheEditorNeedsNoVolume) {
  inputs.volume = nullptr;
  open_dialog();
  EXPECT_EQ(ask().view, picture_of_editor);
  EXPECT_GT(ask().size.x, 100);
  EXPECT_FALSE(has("picture of/0"));
  click("picture file");
  frames(3);
  click("file name");
  for (const char c : std::string_view("curve"))
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(2);
  const auto saved = key_of(ImGuiKey_Enter).save_picture;
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->view, picture_of_editor);
  EXPECT_EQ(saved->path.filename(), "curve.png");
}

}  // namespace
}  // namespace crest::test
