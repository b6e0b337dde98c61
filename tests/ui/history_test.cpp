#include "ui/history.h"

#include <gtest/gtest.h>

namespace crest {
namespace {

Document with_step(double step) {
  Document document;
  document.preset.rendering.step = step;
  return document;
}

double step_of(const Document& document) { return document.preset.rendering.step; }

TEST(History, NothingIsRecordedWhenNothingChanged) {
  History history;
  Document document = with_step(1);
  for (int i = 0; i < 3; ++i) history.record(document);
  EXPECT_FALSE(history.can_undo(document));
  EXPECT_FALSE(history.undo(document));
  EXPECT_EQ(step_of(document), 1);
}

TEST(History, UndoAndRedoWalkTheSteps) {
  History history;
  Document document;
  for (const double step : {1.0, 2.0, 3.0}) history.record(document = with_step(step));
  EXPECT_TRUE(history.undo(document));
  EXPECT_TRUE(history.undo(document));
  EXPECT_EQ(step_of(document), 1);
  EXPECT_FALSE(history.undo(document));
  EXPECT_TRUE(history.redo(document));
  EXPECT_TRUE(history.redo(document));
  EXPECT_EQ(step_of(document), 3);
  EXPECT_FALSE(history.redo(document));
}

TEST(History, ANewEditCutsWhatCouldBeRedone) {
  History history;
  Document document;
  for (const double step : {1.0, 2.0, 3.0}) history.record(document = with_step(step));
  history.undo(document);
  history.record(document = with_step(9));
  EXPECT_FALSE(history.can_redo());
  EXPECT_FALSE(history.redo(document));
  EXPECT_EQ(step_of(document), 9);
  history.undo(document);
  EXPECT_EQ(step_of(document), 2);
}

TEST(History, AnEditThatWasNotRecordedYetIsAStep) {
  History history;
  Document document = with_step(1);
  history.record(document);
  document = with_step(2);
  EXPECT_TRUE(history.can_undo(document));
  EXPECT_TRUE(history.undo(document));
  EXPECT_EQ(step_of(document), 1);
  EXPECT_TRUE(history.redo(document));
  EXPECT_EQ(step_of(document), 2);
}

TEST(History, IsBounded) {
  History history;
  Document document;
  const int edits = int(history_length) + 50;
  for (int i = 0; i <= edits; ++i) history.record(document = with_step(i));
  int undone = 0;
  while (history.undo(document)) ++undone;
  EXPECT_EQ(undone, int(history_length));
  EXPECT_EQ(step_of(document), 50);
}

TEST(History, TheVolumeIsPartOfIt) {
  History history;
  Document document;
  history.record(document);
  document.volume_source = "builtin:plume";
  history.record(document);
  history.undo(document);
  EXPECT_EQ(document.volume_source, "");
}

std::vector<std::string> names_of(const History& history) {
  std::vector<std::string> names;
  for (const HistoryStep& step : history.steps()) names.push_back(step.name);
  return names;
}

TEST(History, StepsHaveNamesAndCanBeGoneTo) {
  History history;
  Document document;
  for (const double step : {1.0, 2.0, 3.0}) history.record(document = with_step(step));
  EXPECT_EQ(names_of(history),
            (std::vector<std::string>{"Start", "Change step from 1 to 2", "Change step from 2 to 3"}));
  EXPECT_EQ(history.present(), 2U);
  EXPECT_TRUE(history.go_to(0, document));
  EXPECT_EQ(step_of(document), 1);
  EXPECT_TRUE(history.go_to(2, document));
  EXPECT_EQ(step_of(document), 3);
  EXPECT_FALSE(history.go_to(3, document));
  EXPECT_EQ(step_of(document), 3);
}

TEST(History, SavingUnderAnotherNameIsNoStepAndUndoStaysInTheNewFile) {
  History history;
  Document document;
  document.library_name = "onion";
  history.record(document);
  document.preset.rendering.step = 2;
  history.record(document);
  document.library_name.clear();
  document.preset_path = "/mine.json";
  history.record(document);
  EXPECT_EQ(history.steps().size(), 2U);
  EXPECT_TRUE(history.undo(document));
  EXPECT_EQ(document.preset_path, "/mine.json");
  EXPECT_EQ(document.library_name, "");
  EXPECT_EQ(step_of(document), 0.5);
}

TEST(History, UndoingAnOpenedPresetGoesBackToItsOwnFile) {
  History history;
  Document document = with_step(1);
  document.preset_path = "/a.json";
  history.record(document);
  document = with_step(2);
  document.preset_path = "/b.json";
  history.record(document);
  document.preset_path = "/c.json";  // saved as
  history.record(document);
  EXPECT_EQ(names_of(history), (std::vector<std::string>{"Start", "Open b.json"}));
  EXPECT_TRUE(history.undo(document));
  EXPECT_EQ(document.preset_path, "/a.json");
}

}  // namespace
}  // namespace crest
