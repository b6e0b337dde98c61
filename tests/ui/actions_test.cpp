#include "ui/actions.h"

#include <fmt/core.h>

#include <map>
#include <set>

#include "tests/ui/harness.h"

namespace crest::test {
namespace {

class Actions : public Studio {
 protected:
  ActionContext context() { return {document, *state, inputs, requests}; }
  std::string whynot(const char* name) { return why_not(action_named(name), context()); }
};

TEST_F(Actions, HaveNamesAndKeysOfTheirOwn) {
  std::set<std::string> names;
  std::map<std::string, std::string> keys;
  for (const Action& action : actions()) {
    EXPECT_TRUE(names.insert(action.name).second) << action.name;
    EXPECT_NE(bool(action.run), bool(action.entries)) << action.name;
    for (const KeyChord& chord : {action.key, action.other_key}) {
      if (chord.key == 0) continue;
      EXPECT_TRUE(keys.emplace(text_of(chord), action.name).second)
          << text_of(chord) << ": " << action.name << ", " << keys[text_of(chord)];
    }
  }
}

TEST_F(Actions, AllOfAMenuStandInItWithTheirKeys) {
  for (int i = 0; i < menu_count; ++i) {
    frames(30);
    click(fmt::format("menu/{}", title_of(Section(i))));
    int count = 0;
    for (const Action& action : actions()) {
      if (action.section != Section(i)) continue;
      ++count;
      const bool is_hidden_list = action.name == "Carry over";
      EXPECT_NE(has(action.entries ? "menu/" + action.name : action.name), is_hidden_list) << action.name;
    }
    EXPECT_GT(count, 0);
    key_of(ImGuiKey_Escape);
  }
}

TEST_F(Actions, TellTheirKeys) {
  EXPECT_EQ(key_text_of("Save as..."), "Ctrl+Shift+S");
  EXPECT_EQ(key_text_of("Delete"), "Delete");
  EXPECT_EQ(key_text_of("Reload shaders"), "F5");
  EXPECT_EQ(key_text_of("Close volume"), "");
  EXPECT_THROW(action_named("Fly"), std::out_of_range);
}

TEST_F(Actions, AKeyIsMeantWithWhatIsHeldWithIt) {
  ImGui::GetIO().KeyCtrl = true;
  key('R');
  EXPECT_EQ(state->views.enlarged, -1);
  ImGui::GetIO().KeyAlt = true;
  EXPECT_FALSE(key('S').save_preset);
  frames(2);
  EXPECT_FALSE(has("file name")) << "Ctrl+Alt+S is no key";
  ImGui::GetIO().KeyCtrl = ImGui::GetIO().KeyAlt = false;
  ImGui::GetIO().KeyShift = true;
  key('3');
  EXPECT_EQ(state->views.enlarged, 2) << "a digit may need Shift";
  key('X');
  EXPECT_TRUE(state->views.exact) << "Shift+X is no key";
  ImGui::GetIO().KeyShift = false;
}

TEST_F(Actions, ALetterThatIsACommandIsNotTypedIntoTheFieldThatItOpens) {
  ImGui::GetIO().AddInputCharacter('p');
  key('P');
  for (const char c : {'4', '2'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
  frames(4);
  key_of(ImGuiKey_Enter);
  frames(2);
  ASSERT_EQ(state->editor.selection.size(), 1u);
  EXPECT_EQ(tf().points[state->editor.selection[0]].value, 42);
}

TEST_F(Actions, AKeyRightAfterEnterCounts) {
  key('P');
  frames(4);
  ImGui::GetIO().KeysDown[key::enter] = true;
  frame();
  ImGui::GetIO().KeysDown[key::enter] = false;
  const std::size_t before = tf().points.size();
  key('S');
  EXPECT_GT(tf().points.size(), before);
}

TEST_F(Actions, LeadToEachTab) {
  for (const char* const tab : tab_names) {
    action_named(fmt::format("Go to {}", tab)).run(context());
    frames(3);
    EXPECT_TRUE(state->asked_tab.empty()) << tab << ": no tab has this name";
  }
  EXPECT_TRUE(has("history/0")) << "the last one is open";
}

TEST_F(Actions, SayWhyTheyCannotBeDone) {
  EXPECT_EQ(whynot("Copy"), "no point is selected");
  EXPECT_EQ(whynot("Stop comparing"), "nothing is compared");
  EXPECT_EQ(whynot("Convert to data values"), "its values are that already");
  EXPECT_EQ(whynot("Undo"), "there is nothing to take back");
  key('P');
  frames(4);
  key_of(ImGuiKey_Enter);
  frames(2);
  EXPECT_EQ(whynot("Copy"), "");
  EXPECT_EQ(whynot("Undo"), "");
  inputs.volume = nullptr;
  EXPECT_EQ(whynot("Close volume"), "no volume is open");
}

TEST_F(Actions, CompareTheViewThatFillsTheGridWithTheNext) {
  state->views.enlarged = 3;
  action_named("Compare by the difference").run(context());
  frame();
  ASSERT_TRUE(requests.comparison);
  EXPECT_EQ(requests.comparison->view, 3);
  EXPECT_EQ(requests.comparison->with, requests.contents[0]);
  EXPECT_EQ(requests.comparison->kind, ComparisonKind::difference);
  const ActionContext now = context();
  action_named("Compare with a snapshot, taken now").run(now);
  tf().points[2].opacity = 0.3;
  frame();
  EXPECT_EQ(requests.comparison->with.other->preset.transfer_function.points[2].opacity, 0.8);
  action_named("Stop comparing").run(context());
  frame();
  EXPECT_FALSE(requests.comparison);
}

TEST_F(Actions, TheListOfKeysHasAllOfThem) {
  key(key::f1);
  frames(3);
  ASSERT_TRUE(has("close help"));
  for (const Action& action : actions())
    EXPECT_EQ(has("key/" + action.name), action.key.key != 0) << action.name;
  key_of(ImGuiKey_Escape);
  frames(2);
  EXPECT_FALSE(has("close help"));
}

}  // namespace
}  // namespace crest::test
