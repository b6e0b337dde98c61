#include "ui/preset_details.h"

#include "tests/ui/harness.h"

namespace crest::test {
namespace {

class Details : public Studio {
 protected:
  Details() {
    document.preset.name = "Bump";
    document.preset.tags = {"CT", "two words"};
    frames(3);
    click("preset title");
  }
  void write(const std::string& field, const std::string& text) {
    click(field);
    ctrl('A');
    for (const char c : text) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    frames(2);
  }
};

TEST_F(Details, NameNotesAndTagsAreEditedInTheWindow) {
  ASSERT_TRUE(has("preset name"));
  write("preset name", "Hill");
  write("preset notes", "For a hill");
  write("preset tags", " MR,  two words ,,MR");
  click("details done");
  EXPECT_FALSE(has("preset name"));
  EXPECT_EQ(document.preset.name, "Hill");
  EXPECT_EQ(document.preset.notes, "For a hill");
  EXPECT_EQ(document.preset.tags, (std::vector<std::string>{"MR", "two words"}));
}

TEST_F(Details, WhatIsTypedInAFieldIsOneStep) {
  write("preset name", "Hill");
  write("preset notes", "x");  // leaves the field before
  click("details done");
  ctrl('Z');
  EXPECT_EQ(document.preset.notes, "");
  EXPECT_EQ(document.preset.name, "Hill");
  ctrl('Z');
  EXPECT_EQ(document.preset.name, "Bump");
}

TEST_F(Details, EnterInTheNameIsDone) {
  write("preset name", "Hill");
  key_of(ImGuiKey_Enter);
  frames(2);
  EXPECT_FALSE(has("preset name"));
  EXPECT_EQ(document.preset.name, "Hill");
}

TEST(Tags, AreReadAsTheyAreWritten) {
  const std::vector<std::string> tags{"CT", "two words", "\xc3\xa4"};
  EXPECT_EQ(tags_text(tags), "CT, two words, \xc3\xa4");
  EXPECT_EQ(tags_in(tags_text(tags)), tags);
  EXPECT_TRUE(tags_in(" , ,").empty());
}

}  // namespace
}  // namespace crest::test
