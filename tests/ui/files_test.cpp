#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "render/volume/builtin.h"
#include "tests/ui/harness.h"

namespace crest::test {
namespace {

namespace fs = std::filesystem;

/// A folder with two files and a folder in it, gone afterwards.
class Files : public Studio {
 protected:
  Files() {
    fs::create_directories(folder / "inner");
    std::ofstream(folder / "old.json") << "{}";
    std::ofstream(folder / "a.nrrd") << "NRRD";
    state->file_dialog.folder = folder;
    document.volume_source = (folder / "a.nrrd").string();
    frames(2);
  }
  ~Files() override { fs::remove_all(folder); }

  /// Writes into the dialog's name field, which has the focus, and presses Enter.
  StudioRequests name(const std::string& text) {
    click("file name");
    ctrl('A');
    for (const char c : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    frames(2);
    const StudioRequests result = key_of(ImGuiKey_Enter);
    frames(2);
    return result;
  }
  void choose(const char* menu, const char* item) {
    frames(30);
    click(std::string("menu/") + menu);
    move_to(center_of(item));
    press();
    release();
  }

  fs::path folder = fs::canonical(fs::temp_directory_path()) / ("crest_ui_" + std::to_string(::getpid()));
};

TEST_F(Files, AreListedAsAPersonCounts) {
  for (const char* file : {"step_55.nrrd", "step_5.nrrd", "Step_6.nrrd", "step_10.nrrd"})
    std::ofstream(folder / file) << "NRRD";
  ctrl('O');
  frames(2);
  std::vector<std::string> names;
  for (const auto& entry : state->file_dialog.entries)
    if (entry.name.find("tep_") != entry.name.npos) names.push_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string>{"step_5.nrrd", "Step_6.nrrd", "step_10.nrrd", "step_55.nrrd"}));
}

TEST_F(Files, AVolumeIsOpenedFromTheList) {
  ctrl('O');
  frames(2);
  ASSERT_TRUE(has("file/a.nrrd"));
  move_to(center_of("file/a.nrrd"));
  press();
  release();
  press();
  EXPECT_EQ(requests.open_volume, (folder / "a.nrrd").string());
  release();
  frames(2);
  EXPECT_FALSE(has("file name"));
}

TEST_F(Files, APathWithAQueryIsTakenAsItIs) {
  ctrl('O');
  frames(2);
  EXPECT_EQ(name("head.raw?size=2x2x2&type=uint8").open_volume,
            (folder / "head.raw?size=2x2x2&type=uint8").string());
}

TEST_F(Files, WhatIsNotThereIsSaid) {
  ctrl('O');
  frames(2);
  EXPECT_FALSE(name("no-such.nrrd").open_volume);
  EXPECT_NE(state->file_dialog.error.find("no such file"), std::string::npos);
  ASSERT_TRUE(has("cancel file"));
  click("cancel file");
  EXPECT_FALSE(has("file name"));
}

TEST_F(Files, PresetsAreFilteredAndFoldersEntered) {
  ctrl('O', true);
  frames(2);
  EXPECT_TRUE(has("file/old.json"));
  EXPECT_FALSE(has("file/a.nrrd"));
  double_click(center_of("file/inner"));
  EXPECT_EQ(state->file_dialog.folder, folder / "inner");
  click("folder up");
  EXPECT_EQ(state->file_dialog.folder, folder);
  EXPECT_EQ(name("old.json").open_preset, (folder / "old.json").string());
}

TEST_F(Files, SavingAsksWhereThenOverwritesOnlyWhenToldTo) {
  ctrl('S');
  frames(2);
  ASSERT_TRUE(has("file name"));
  EXPECT_FALSE(name("old").save_preset);
  ASSERT_TRUE(state->file_dialog.to_replace);
  click("keep");
  EXPECT_FALSE(state->file_dialog.to_replace);
  EXPECT_FALSE(name("old.json").save_preset);
  frames(2);
  move_to(center_of("replace"));
  press();
  release();
  EXPECT_EQ(requests.save_preset, folder / "old.json");
}

TEST_F(Files, SavingToANewNameAndToTheKnownOne) {
  ctrl('S', true);
  frames(2);
  EXPECT_EQ(name("new").save_preset, folder / "new.json");
  document.preset_path = folder / "new.json";
  EXPECT_EQ(ctrl('S').save_preset, folder / "new.json");
  ctrl('S', true);
  frames(2);
  EXPECT_FALSE(name("nowhere/new").save_preset);
  EXPECT_NE(state->file_dialog.error.find("no such folder"), std::string::npos);
}

TEST_F(Files, TheMenusAskForWhatTheyName) {
  choose("Preset", "New");
  EXPECT_TRUE(requests.new_preset);
  choose("View", "Reload shaders");
  EXPECT_TRUE(requests.reload_shaders);
  EXPECT_TRUE(key(294).reload_shaders);
  inputs.recent = {"/x/one.nrrd", "/x/two.json"};
  click("menu/Volume");
  click("menu/Recent volumes");
  EXPECT_FALSE(has("/x/two.json"));
  move_to(center_of("/x/one.nrrd"));
  press();
  release();
  EXPECT_EQ(requests.open_volume, "/x/one.nrrd");
}

TEST_F(Files, BuiltInVolumesAreOffered) {
  const std::string volume_name(builtins().front().name);
  click("menu/Volume");
  click("menu/Built-in");
  move_to(center_of(volume_name));
  press();
  release();
  EXPECT_EQ(requests.open_volume, "builtin:" + volume_name);
}

TEST_F(Files, FittingAndConvertingTheValues) {
  tf().points = points_of({{1000, 0}, {2000, 0.5}, {3000, 0}});
  frames(2);
  choose("Preset", "Fit to the volume's range");
  EXPECT_NEAR(tf().points[1].value, 50, 1e-9);
  choose("Preset", "Convert to normalized values");
  EXPECT_EQ(tf().domain, Domain::normalized);
  EXPECT_NEAR(tf().points[1].value, 0.5, 1e-12);
  choose("Preset", "Convert to data values");
  EXPECT_NEAR(tf().points[1].value, 50, 1e-9);
  frames(30);
  ctrl('Z');
  EXPECT_EQ(tf().domain, Domain::normalized);
}

TEST_F(Files, QuittingAsksOnlyAboutUnsavedChanges) {
  EXPECT_TRUE(ctrl('Q').quit);
  inputs.unsaved_changes = true;
  EXPECT_FALSE(ctrl('Q').quit);
  click("Stay");
  EXPECT_FALSE(requests.quit);
  EXPECT_FALSE(has("Stay"));
  inputs.close_requested = true;
  frame();
  inputs.close_requested = false;
  frames(3);
  move_to(center_of("Discard"));
  press();
  release();
  EXPECT_TRUE(requests.quit);
}

TEST_F(Files, QuittingWaitsForAPictureThatIsBeingSaved) {
  inputs.saving = "Saving turn.png: 3 of 36";
  EXPECT_FALSE(ctrl('Q').quit);
  frames(3);
  ASSERT_TRUE(has("Quit anyway"));
  EXPECT_TRUE(requests.animates);
  inputs.saving.clear();
  bool quits = false;
  for (int i = 0; i < 3; ++i) quits |= frame().quit;
  EXPECT_TRUE(quits);
}

TEST_F(Files, APictureCanBeGivenUpOrTheProgramKept) {
  inputs.saving = "Saving turn.png: 3 of 36";
  ctrl('Q');
  frames(3);
  key_of(ImGuiKey_Escape);
  frames(2);
  EXPECT_FALSE(has("Quit anyway"));
  ctrl('Q');
  frames(3);
  EXPECT_TRUE(press_on("Quit anyway").quit);
  // What could not be saved is told, not left behind
  frames(3);
  ctrl('Q');
  frames(3);
  inputs.saving.clear();
  inputs.message = "turn.png: the disk is full";
  inputs.message_is_error = true;
  bool quits = false;
  for (int i = 0; i < 5; ++i) quits |= frame().quit;
  EXPECT_FALSE(quits);
  EXPECT_FALSE(has("Quit anyway"));
}

TEST_F(Files, SaveBeforeQuitting) {
  inputs.unsaved_changes = true;
  document.preset_path = folder / "mine.json";
  ctrl('Q');
  frames(2);
  move_to(center_of("Save##quit"));
  press();
  release();
  EXPECT_EQ(requests.save_preset, folder / "mine.json");
  EXPECT_TRUE(requests.quit);
}

TEST_F(Files, SaveBeforeQuittingToANewName) {
  inputs.unsaved_changes = true;
  ctrl('Q');
  frames(2);
  click("Save##quit");
  frames(2);
  const StudioRequests saved = name("mine");
  EXPECT_EQ(saved.save_preset, folder / "mine.json");
  EXPECT_TRUE(saved.quit);
}

TEST_F(Files, NewAndOpeningAnotherPresetAskAboutUnsavedChanges) {
  inputs.unsaved_changes = true;
  document.preset_path = folder / "mine.json";
  choose("Preset", "New");
  EXPECT_FALSE(requests.new_preset);
  frames(3);
  click("Stay");
  frames(3);
  EXPECT_FALSE(requests.new_preset);
  choose("Preset", "New");
  frames(3);
  move_to(center_of("Discard"));
  press();
  release();
  EXPECT_TRUE(requests.new_preset);
  EXPECT_FALSE(requests.save_preset);
  EXPECT_FALSE(requests.quit);

  inputs.dropped_preset = "/x/other.json";
  EXPECT_FALSE(frame().open_preset);
  inputs.dropped_preset.reset();
  frames(3);
  move_to(center_of("Save##quit"));
  press();
  release();
  EXPECT_EQ(requests.save_preset, folder / "mine.json");
  EXPECT_EQ(requests.open_preset, "/x/other.json") << "once it is saved";
  frames(3);
  EXPECT_FALSE(requests.open_preset);
  EXPECT_FALSE(has("Stay"));
}

TEST_F(Files, APresetIsOpenedAtOnceWhereNothingIsLost) {
  inputs.dropped_preset = "/x/other.json";
  EXPECT_EQ(frame().open_preset, "/x/other.json");
  inputs.dropped_preset.reset();
  frames(3);
  EXPECT_FALSE(requests.open_preset);
}

TEST_F(Files, TheQuestionListsWhatChangedAndEscapeStays) {
  const Preset saved = document.preset;
  tf().points[2].opacity = 0.5;
  inputs.unsaved_changes = true;
  inputs.saved = &saved;
  ctrl('Q');
  frames(3);
  ASSERT_TRUE(has("Stay"));
  key_of(ImGuiKey_Escape);
  frames(3);
  EXPECT_FALSE(has("Stay"));
  EXPECT_FALSE(requests.quit);
  inputs.unsaved_changes = false;
  EXPECT_TRUE(ctrl('Q').quit) << "it was forgotten, not kept for later";
}

TEST_F(Files, GivingNoNameGivesUpWhatWaited) {
  inputs.unsaved_changes = true;
  document.library_name = "onion";
  choose("Preset", "New");
  frames(3);
  click("Save##quit");
  frames(3);
  EXPECT_EQ(state->file_dialog.name, "onion.json");
  click("cancel file");
  frames(3);
  EXPECT_FALSE(requests.new_preset);
  const StudioRequests saved = (ctrl('S'), frames(3), name("later"));
  EXPECT_EQ(saved.save_preset, folder / "later.json");
  EXPECT_FALSE(saved.new_preset);
}

TEST_F(Files, TypingInAFieldIsNotACommand) {
  inputs.volume = &volume;
  document.preset.camera = Camera{};
  frames(30);
  click(place_of(2));
  click("##value");
  key('R');
  key_of(ImGuiKey_Delete);
  EXPECT_TRUE(document.preset.camera);
  EXPECT_EQ(tf().points.size(), 5U);
}

}  // namespace
}  // namespace crest::test
