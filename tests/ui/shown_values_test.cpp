#include "ui/shown_values.h"

#include "presets/number_text.h"
#include "tests/ui/harness.h"

namespace crest::test {
namespace {

TransferFunction normalized(std::initializer_list<std::pair<double, double>> places) {
  TransferFunction tf = tf_of(places);
  tf.domain = Domain::normalized;
  return tf;
}

TEST(ShownValues, AreShortAndKeepWhatIsClose) {
  const TransferFunction tf = normalized({{0, 0}, {0.3, 0}, {0.3 + 1e-9, 1}, {0.3 + 2e-9, 0}, {0.9, 0.2}});
  const TransferFunction shown = shown_values(tf, Domain::data, {1e-5, 0.987994});
  EXPECT_EQ(shown.domain, Domain::data);
  EXPECT_LT(exact_text(shown.points[4].value).size(), 10U) << exact_text(shown.points[4].value);
  EXPECT_NEAR(shown.points[4].value, 1e-5 + 0.9 * 0.987984, 1e-5);
  for (std::size_t i = 0; i + 1 < 5; ++i) EXPECT_LT(shown.points[i].value, shown.points[i + 1].value) << i;
}

TEST(ShownValues, WhatIsLeftAloneStaysToTheBit) {
  const TransferFunction tf = normalized({{0.1, 0}, {1.0 / 3, 0.5}, {1.0 / 3, 0.9}, {0.7, 0.1}});
  const ValueRange volume{-1024, 3071};
  TransferFunction edited = shown_values(tf, Domain::data, volume);
  EXPECT_EQ(stored_values(edited, tf, volume), tf);
  edited.points[3].value = 2000;
  const TransferFunction back = stored_values(edited, tf, volume);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(back.points[i].value, tf.points[i].value) << i;
  EXPECT_NEAR(back.points[3].value, 3024.0 / 4095, 1e-13);
  EXPECT_EQ(shown_values(back, Domain::data, volume).points[3].value, 2000) << "what was typed is shown";
}

TEST(ShownValues, AreConvertedAgainOnlyWhereSomethingChanged) {
  TransferFunction tf = normalized({{0, 0}, {0.5, 0.4}, {1, 0}});
  const TransferFunction stored = tf;
  const ValueRange volume{0, 100}, other_volume{0, 200};
  ShownCurve kept;
  double seen = 0;
  const auto look = [&](const ValueRange& range) {
    return edit_shown(tf, {}, &range, kept, [&] { return seen = tf.points[1].value, false; });
  };
  look(volume);
  EXPECT_EQ(seen, 50);
  kept.shown.points[1].value = 51;  // what is kept is what is shown
  look(volume);
  EXPECT_EQ(seen, 51);
  EXPECT_EQ(tf, stored);
  look(other_volume);
  EXPECT_EQ(seen, 100);
  tf.points[1].value = 0.25;
  look(other_volume);
  EXPECT_EQ(seen, 50);
  EXPECT_EQ(tf.points[1].value, 0.25);
}

using ShownValuesInTheEditor = Studio;

TEST_F(ShownValuesInTheEditor, ANormalizedCurveIsEditedInDataValues) {
  document.preset.transfer_function = normalized({{0, 0}, {0.25, 0.4}, {0.5, 0}, {1, 0.5}});
  frames(3);
  click("point/1");
  type("##value", "30");
  EXPECT_EQ(tf().domain, Domain::normalized) << "the file keeps its form";
  EXPECT_DOUBLE_EQ(tf().points[1].value, 0.3);
  click("values/normalized");
  EXPECT_FALSE(state->settings.data_values);
  frames(2);
  type("##value", "0.2");
  EXPECT_DOUBLE_EQ(tf().points[1].value, 0.2);
  click("values/data");
  EXPECT_TRUE(state->settings.data_values);
}

TEST_F(ShownValuesInTheEditor, ACurveInDataValuesIsSeenFrom0To1) {
  click("values/normalized");
  frames(2);
  click("point/1");
  type("##value", "0.3");
  EXPECT_EQ(tf().domain, Domain::data);
  EXPECT_DOUBLE_EQ(tf().points[1].value, 30);
}

TEST_F(ShownValuesInTheEditor, LookingChangesNothing) {
  document.preset.transfer_function = normalized({{0, 0}, {1.0 / 3, 0.4}, {0.5, 0}, {1, 0.5}});
  const TransferFunction before = tf();
  frames(3);
  click("tab/Points");
  click("values/normalized");
  click("values/data");
  EXPECT_EQ(tf(), before);
  EXPECT_FALSE(requests.document_changed);
}

}  // namespace
}  // namespace crest::test
