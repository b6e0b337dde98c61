#include "tests/ui/harness.h"
#include "ui/document_changes.h"

namespace crest::test {
namespace {

class HistoryPanel : public Studio {
 protected:
  HistoryPanel() { click("tab/History"); }
  void edit(double opacity) {
    tf().points[2].opacity = opacity;
    frames(3);
  }
};

TEST_F(HistoryPanel, AClickGoesToAStep) {
  edit(0.7);
  edit(0.6);
  edit(0.5);
  ASSERT_TRUE(has("history/3"));
  click("history/1");
  EXPECT_EQ(tf().points[2].opacity, 0.7);
  click("history/3");
  EXPECT_EQ(tf().points[2].opacity, 0.5) << "what is undone can be gone to";
  click("history/0");
  EXPECT_EQ(tf().points[2].opacity, 0.8);
  ctrl('Y');
  EXPECT_EQ(tf().points[2].opacity, 0.7) << "undo and redo go on from there";
  edit(0.1);
  EXPECT_FALSE(has("history/3")) << "a new edit cuts what was undone";
  EXPECT_TRUE(has("history/2"));
}

TEST_F(HistoryPanel, TheLastOfManyStepsIsInSight) {
  for (int i = 0; i < 60; ++i) edit(0.01 * i);
  const ImVec2 last = center_of("history/60");
  EXPECT_LT(last.y, ImGui::GetIO().DisplaySize.y);
  click("history/60");
  EXPECT_EQ(tf().points[2].opacity, 0.59);
}

TEST(DocumentChanges, StepsAreNamedByWhatLedThere) {
  Document before;
  before.preset.transfer_function = default_transfer_function();
  Document after = before;
  after.volume_source = "/scans/head.nrrd?component=0";
  EXPECT_EQ(describe_step(before, after), "Open head.nrrd?component=0");
  after = before;
  after.preset.rendering.step = 3;
  after.preset_path = "/p/mine.json";
  EXPECT_EQ(describe_step(before, after), "Open mine.json");
  after.preset_path.clear();
  after.library_name = "onion";
  EXPECT_EQ(describe_step(before, after), "Open onion (library)");
  EXPECT_EQ(describe_step(after, before), "New preset");
  after = before;
  after.preset.notes = "a";
  after.preset.rendering.step = 3;
  after.preset.camera = Camera{};
  EXPECT_EQ(describe_step(before, after), "Change the notes and 2 more changes");
}

TEST(DocumentChanges, AMeasuredSettingIsNamedByItsMethod) {
  Document before;
  for (const Method& method : methods()) {
    Document after = before;
    after.preset.rendering = with_method(before.preset.rendering, method, 0.125);
    const std::string name = describe_step(before, after);
    if (!name.starts_with("Take setting")) {
      EXPECT_LT(changes_since(before.preset, after.preset).size(), 2U) << method.id << ": " << name;
      continue;
    }
    EXPECT_NE(name.find(method.name), name.npos) << name;
    EXPECT_EQ(name.find("1/8") != name.npos, method.has_step) << name;
  }
}

TEST(DocumentChanges, TheCameraIsNothingToSave) {
  Preset saved, now;
  now.camera = Camera{};
  EXPECT_TRUE(changes_since(saved, now).empty());
  now.rendering.step = 1;
  EXPECT_EQ(changes_since(saved, now).size(), 1U);
}

}  // namespace
}  // namespace crest::test
