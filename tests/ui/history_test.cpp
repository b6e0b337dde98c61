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

}  // namespace
}  // namespace crest
