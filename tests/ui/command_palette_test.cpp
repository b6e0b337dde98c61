#include "ui/command_palette.h"

#include "tests/ui/harness.h"
#include "ui/fuzzy_match.h"

namespace crest::test {
namespace {

class CommandPalette : public Studio {
 protected:
  void open() {
    ctrl('P', true);
    frames(3);
    ASSERT_TRUE(has("palette search"));
  }
  void write(std::string_view text) {
    for (const char c : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    frames(2);
  }
  StudioRequests enter() { return key(key::enter); }
  std::string first(std::string_view typed) {
    const std::vector<PaletteRow> rows = palette_rows({document, *state, inputs, requests}, typed);
    return rows.empty() ? "" : rows[0].title;
  }
};

TEST(FuzzyMatch, LettersInTheirOrder) {
  EXPECT_TRUE(match_score("svas", "Save as..."));
  EXPECT_FALSE(match_score("sa sx", "Save as..."));
  EXPECT_FALSE(match_score("ass", "Save as...")) << "each letter once";
  EXPECT_FALSE(match_score("a", ""));
  EXPECT_TRUE(match_score("", "Save"));
  EXPECT_TRUE(match_score("as SAVE", "Save as...")) << "words in any order, large or small";
}

TEST(FuzzyMatch, BeginningsOfWordsAndRunsCountForMore) {
  EXPECT_GT(match_score("sa", "Save as..."), match_score("sa", "Mouse pad"));
  EXPECT_GT(match_score("sp", "Add spike"), match_score("sp", "As map"));
  EXPECT_GT(match_score("oe", "Open Elephant"), match_score("oe", "Oboe"));
  // The best of all ways: not the first s, but the one that begins a word
  EXPECT_EQ(match_score("st", "Last step"), match_score("st", "Also step"));
}

TEST_F(CommandPalette, FindsWhatIsMeant) {
  EXPECT_EQ(first("save as"), "Save as...");
  EXPECT_EQ(first("gyroid"), "Open builtin:gyroid");
  EXPECT_EQ(first("open gyr"), "Open builtin:gyroid");
  EXPECT_EQ(first("spike"), "Add spike");
  EXPECT_EQ(first("onion"), "Open preset onion");
  EXPECT_EQ(first("viridis"), "Colours: viridis");
  EXPECT_EQ(first("xyzzy"), "");
  EXPECT_NE(first("comp"), "Stop comparing") << "what cannot be done comes last";
  inputs.recent = {"/scans/head.nrrd", "/scans/bones.json"};
  EXPECT_EQ(first("head"), "Open /scans/head.nrrd");
  EXPECT_EQ(first("bones"), "Open /scans/bones.json");
}

TEST_F(CommandPalette, EnterRunsWhatIsMarked) {
  open();
  write("gyroid");
  EXPECT_EQ(enter().open_volume, "builtin:gyroid");
  frames(2);
  EXPECT_FALSE(has("palette search"));
}

TEST_F(CommandPalette, TypingMayBeginAtOnce) {
  ctrl('P', true);
  write("reload");
  EXPECT_TRUE(enter().reload_shaders);
}

TEST_F(CommandPalette, ChangesOfTheDocumentAreOneStep) {
  const std::size_t before = tf().points.size();
  open();
  write("add box");
  enter();
  frames(2);
  EXPECT_GT(tf().points.size(), before);
  EXPECT_EQ(state->history.steps().size(), 2u);
}

TEST_F(CommandPalette, ArrowsChooseAndGoRound) {
  open();
  write("compare by");
  const auto rows = palette_rows({document, *state, inputs, requests}, "compare by");
  ASSERT_GT(rows.size(), 2u);
  key(key::down);
  EXPECT_EQ(state->palette.selected, 1);
  key(key::up);
  key(key::up);
  EXPECT_EQ(state->palette.selected, int(rows.size()) - 1);
  key(key::down);
  key(key::down);
  enter();
  frames(2);
  ASSERT_TRUE(requests.comparison);
  EXPECT_EQ(state->palette.chosen.front(), rows[1].title);
}

TEST_F(CommandPalette, WhatWasChosenLastComesFirst) {
  open();
  write("go to slices");
  enter();
  frames(2);
  EXPECT_EQ(first(""), "Go to Slices");
  open();
  EXPECT_EQ(state->palette.typed, "");
  enter();
  frames(3);
  EXPECT_EQ(first(" "), "Go to Slices");
}

TEST_F(CommandPalette, ABuiltInVolumeThatWasOpenStandsOnce) {
  inputs.recent = {"builtin:gyroid"};
  int count = 0;
  for (const PaletteRow& row : palette_rows({document, *state, inputs, requests}, ""))
    count += row.title == "Open builtin:gyroid";
  EXPECT_EQ(count, 1);
}

TEST_F(CommandPalette, WhatCannotBeDoneSaysWhyAndStays) {
  open();
  write("stop comp");
  enter();
  frames(3);
  EXPECT_TRUE(has("palette search"));
  EXPECT_EQ(palette_rows({document, *state, inputs, requests}, "stop comp")[0].why_not,
            "nothing is compared");
  key(key::escape);
  frames(2);
  EXPECT_FALSE(has("palette search"));
}

TEST_F(CommandPalette, EscapeClosesAndDoesNothingElse) {
  state->editor.selection = {2};
  open();
  key(key::escape);
  frames(2);
  EXPECT_FALSE(has("palette search"));
  EXPECT_EQ(state->editor.selection, Selection{2});
}

TEST_F(CommandPalette, AClickChoosesToo) {
  open();
  write("quit");
  click("palette/Quit");
  frames(2);
  EXPECT_FALSE(has("palette search"));
  EXPECT_EQ(state->palette.chosen.front(), "Quit");
}

TEST_F(CommandPalette, TheManualIsAskedFor) {
  open();
  write("manual");
  EXPECT_EQ(enter().open_manual, "");
  open();
  write("about");
  enter();
  frames(2);
  EXPECT_TRUE(has("close about"));
}

}  // namespace
}  // namespace crest::test
