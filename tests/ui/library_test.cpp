#include "ui/library_window.h"

#include <imgui_internal.h>

#include "tests/ui/harness.h"

namespace crest::test {
namespace {

class Library : public Studio {
 protected:
  Library() {
    entries.push_back({"/mine/a.json", "/mine/a.json", "My skull", "of a CT", {"CT", "bone"}, 0});
    entries.push_back({"onion", {}, "Onion", "Eight shells", {"shells"}, 0});
    entries.push_back({"fire", {}, "Fire over decades", "Thin shells", {"smoke"}, 0});
    inputs.library = entries;
    frames(3);
    EXPECT_TRUE(ctrl('L').reads_library);
    frames(3);
  }
  void search(const std::string& text) {
    click("library search");
    ctrl('A');
    key_of(ImGuiKey_Backspace);
    for (const char c : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    frames(3);
  }

  /// Whether the keyboard is on the widget with this label, of its window.
  static bool focus_is_on(const char* label) {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    return g.NavWindow && g.NavId == g.NavWindow->GetID(label);
  }
  /// By Tab, as far as it leads.
  bool tab_to(const char* label) {
    for (int i = 0; i < 60 && !focus_is_on(label); ++i) {
      key_of(ImGuiKey_Tab);
      frames(2);
    }
    return focus_is_on(label);
  }

  std::vector<LibraryEntry> entries;
};

TEST_F(Library, ADoubleClickOpensAPreset) {
  EXPECT_TRUE(requests.shows_library);
  std::optional<std::string> opened;
  move_to(center_of("library/onion"));
  for (const bool down : {true, false, true, false}) {
    down ? press() : release();
    if (requests.open_preset) opened = requests.open_preset;
  }
  frames(1);
  EXPECT_EQ(opened, "onion");
  EXPECT_FALSE(has("library/fire"));
  EXPECT_FALSE(requests.shows_library);
}

TEST_F(Library, WhatIsChosenIsOpenedWholeOrInPart) {
  click("library/onion");
  ASSERT_TRUE(has("library/Open"));
  const StudioRequests whole = press_on("library/Open");
  EXPECT_EQ(whole.open_preset, "onion");
  EXPECT_EQ(whole.take, TfParts::both);
  frames(3);
  EXPECT_FALSE(has("library/onion"));
  ctrl('L');
  frames(3);
  click("library/fire");
  const StudioRequests part = press_on("library/Opacities only");
  EXPECT_EQ(part.open_preset, "fire");
  EXPECT_EQ(part.take, TfParts::opacities);
}

TEST_F(Library, EnterOpensAndEscapeCloses) {
  click("library/onion");
  EXPECT_EQ(key_of(ImGuiKey_Enter).open_preset, "onion");
  frames(3);
  ctrl('L');
  frames(30);
  key_of(ImGuiKey_Escape);  // of the search field
  key_of(ImGuiKey_Escape);
  frames(2);
  EXPECT_FALSE(has("library/onion"));
}

TEST_F(Library, EnterOnAButtonPressesThatAlone) {
  click("library/onion");
  ASSERT_TRUE(tab_to("Duplicate"));
  const StudioRequests entered = key_of(ImGuiKey_Enter);
  EXPECT_FALSE(entered.open_preset);
  ASSERT_TRUE(entered.library);
  EXPECT_EQ(entered.library->change, LibraryChange::duplicate);
}

TEST_F(Library, EnterOnACardOpensIt) {
  click("library/onion");
  ASSERT_TRUE(tab_to("library/fire"));
  EXPECT_EQ(key_of(ImGuiKey_Enter).open_preset, "fire");
}

TEST_F(Library, IsSearchedByWordsAndTags) {
  search("SHELLS thin");
  EXPECT_FALSE(has("library/onion"));
  EXPECT_TRUE(has("library/fire"));
  search("");
  EXPECT_TRUE(has("library/onion"));
  click("library tag/bone");
  EXPECT_TRUE(has("library//mine/a.json"));
  EXPECT_FALSE(has("library/onion"));
  click("library tag/bone");
  EXPECT_TRUE(has("library/onion"));
}

TEST_F(Library, AllTagsAreShownInRows) {
  for (int i = 0; i < 60; ++i) entries[0].tags.push_back("a long tag with the number " + std::to_string(i));
  inputs.library = entries;
  frames(2);
  for (const std::string& tag : entries[0].tags) ASSERT_TRUE(has("library tag/" + tag)) << tag;
  click("library tag/a long tag with the number 59");
  EXPECT_TRUE(has("library//mine/a.json"));
  EXPECT_FALSE(has("library/onion"));
}

TEST_F(Library, OnlyOnesOwnAreRenamedAndDeleted) {
  click("library/onion");
  EXPECT_FALSE(has("library/Delete"));
  EXPECT_FALSE(has("library/Rename..."));
  const StudioRequests copied = press_on("library/Duplicate");
  ASSERT_TRUE(copied.library);
  EXPECT_EQ(copied.library->change, LibraryChange::duplicate);
  EXPECT_EQ(copied.library->preset, "onion");
  frames(30);
  click("library//mine/a.json");
  const StudioRequests deleted = press_on("library/Delete");
  ASSERT_TRUE(deleted.library);
  EXPECT_EQ(deleted.library->change, LibraryChange::remove);
  EXPECT_EQ(deleted.library->preset, "/mine/a.json");
  frames(30);
  click("library/Rename...");
  click("library name");
  ctrl('A');
  for (const char c : std::string("Skull")) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(2);
  const StudioRequests renamed = press_on("library/Take the name");
  ASSERT_TRUE(renamed.library);
  EXPECT_EQ(renamed.library->change, LibraryChange::rename);
  EXPECT_EQ(renamed.library->title, "Skull");
}

TEST_F(Library, ThePresentPresetIsKept) {
  const StudioRequests added = press_on("library/Add the present preset");
  ASSERT_TRUE(added.library);
  EXPECT_EQ(added.library->change, LibraryChange::add);
}

TEST_F(Library, OpeningAsksAboutUnsavedChanges) {
  inputs.unsaved_changes = true;
  click("library/onion");
  EXPECT_FALSE(press_on("library/Open").open_preset);
  frames(3);
  EXPECT_EQ(press_on("Discard").open_preset, "onion");
}

}  // namespace
}  // namespace crest::test
