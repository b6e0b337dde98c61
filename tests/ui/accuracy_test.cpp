#include <algorithm>
#include <cmath>

#include "render/measure/methods.h"
#include "tests/measure/measurements.h"
#include "tests/ui/harness.h"
#include "ui/accuracy_plot.h"

namespace crest::test {
namespace {

/// A second-order and a first-order method against `integral`, one more against `crossings`.
class Accuracy : public Studio {
 protected:
  Accuracy() {
    document.preset.rendering.mode = Mode::dvr_only;
    results.size = {256, 240};
    for (const double step : {2.0, 1.0, 0.5, 0.25}) {
      add("dvr", step, 10 / step, 0.016 * step * step);
      add("dvr-eye", step, 8 / step, 0.016 * step);
    }
    add("peaks", 1, 5, 0.5, Answer::crossings);
    inputs.accuracy = &results;
    click("tab/Accuracy");
  }

  void add(const char* method, double step, double ms, double error,
           const ExactAnswer& answer = Answer::integral) {
    results.measured.push_back(crest::testing::measurement(method, step, ms, error, answer));
  }
  ImVec2 place(const std::string& point) const { return center_of("measured/" + point); }
  const Rendering& rendering() const { return document.preset.rendering; }

  AccuracyResults results;
};

TEST_F(Accuracy, PointsLieOnLogarithmicAxes) {
  // Halving the step: 2 times the time, a quarter of the error or half of it
  const ImVec2 a = place("dvr/2"), b = place("dvr/1"), c = place("dvr/0.5"), eye = place("dvr-eye/1");
  EXPECT_GT(b.x - a.x, 20);
  EXPECT_NEAR(c.x - b.x, b.x - a.x, 1);
  EXPECT_GT(b.y - a.y, 20) << "less error lies lower";
  EXPECT_NEAR(c.y - b.y, b.y - a.y, 1);
  EXPECT_NEAR(place("dvr-eye/0.5").y - eye.y, (c.y - b.y) / 2, 1);
  EXPECT_FALSE(has("measured/peaks/1")) << "it is of another exact answer";
  const auto [low, high] = state->widgets.items.at("accuracy plot");
  for (const auto& [name, rect] : state->widgets.items) {
    if (!name.starts_with("measured/")) continue;
    EXPECT_GT(rect.first.x, low.x) << name;
    EXPECT_LT(rect.first.x, high.x) << name;
    EXPECT_GT(rect.first.y, low.y) << name;
    EXPECT_LT(rect.first.y, high.y) << name;
  }
}

TEST_F(Accuracy, AnswersAreChosen) {
  click("answer/crossings");
  EXPECT_TRUE(has("measured/peaks/1"));
  EXPECT_FALSE(has("measured/dvr/1"));
  click("answer/base+crossings");
  EXPECT_FALSE(has("measured/peaks/1"));
  EXPECT_FALSE(has("method/peaks"));
}

TEST_F(Accuracy, OtherFiltersHaveAnswersOfTheirOwn) {
  const Rendering before = rendering();
  add("dvr-bspline", 1, 30, 0.001, exact_answers_of(*find_method("dvr-bspline")).front());
  frames(2);
  EXPECT_FALSE(has("measured/dvr-bspline/1"));
  click("answer/integral (bspline)");
  EXPECT_TRUE(has("measured/dvr-bspline/1"));
  click(place("dvr-bspline/1"));
  EXPECT_EQ(rendering().filter, Filter::bspline);
  // What was measured is of the scene's own filter: that comes back with its methods
  click("answer/integral");
  click(place("dvr/1"));
  EXPECT_EQ(rendering().filter, before.filter);
}

TEST_F(Accuracy, AClickTakesTheSettingAndOneUndoTakesItBack) {
  document.preset.rendering.shading = Shading::gradient;
  frames(2);
  const Document before = document;
  click(place("dvr-eye/0.25"));
  EXPECT_EQ(rendering().mode, Mode::dvr_only);
  EXPECT_EQ(rendering().placement, Placement::eye);
  EXPECT_EQ(rendering().step, 0.25);
  EXPECT_EQ(rendering().shading, Shading::gradient) << "which no method sets";
  ctrl('Z');
  EXPECT_EQ(document, before);
}

TEST_F(Accuracy, TheAnswerStaysWhenAClickChangesTheMode) {
  click("answer/crossings");
  click(place("peaks/1"));
  EXPECT_EQ(rendering().mode, Mode::peak_only);
  EXPECT_TRUE(has("measured/peaks/1"));
  click("answer/integral");
  click(place("dvr/1"));
  EXPECT_EQ(rendering().mode, Mode::dvr_only);
  EXPECT_TRUE(has("measured/dvr/1"));
}

TEST_F(Accuracy, AClickBesideThePointsChangesNothing) {
  const Document before = document;
  const auto [low, high] = state->widgets.items.at("accuracy plot");
  click(ImVec2{high.x - 30, low.y + 30});
  EXPECT_EQ(document, before);
}

TEST_F(Accuracy, ARowTakesTheCheapestSettingThatMeetsTheTarget) {
  // dvr has 0.016, 0.004, 0.001 from step 1 on; dvr-eye only 0.004 at its finest
  click("method/dvr-eye");
  EXPECT_EQ(rendering().placement, Placement::entry_exit_corner) << "it never meets the target";
  type("##target error", "0.005");
  click("method/dvr");
  EXPECT_EQ(rendering().step, 0.5);
  click("method/dvr-eye");
  EXPECT_EQ(rendering().placement, Placement::eye);
  EXPECT_EQ(rendering().step, 0.25);
}

TEST_F(Accuracy, MeasureSwitchesOnAndOff) {
  EXPECT_FALSE(requests.measure);
  const auto pressed = [&] {
    move_to(center_of("measure"));
    press();
    release();
    return requests.measure;
  };
  EXPECT_EQ(pressed(), std::optional(true));
  frame();
  EXPECT_FALSE(requests.measure) << "it is asked for once";
  EXPECT_TRUE(has("measure/Measure again"));
  results.is_on = results.is_running = true;
  EXPECT_EQ(pressed(), std::optional(false));
  EXPECT_TRUE(has("measure/Stop"));
  results.is_running = false;  // all is measured
  EXPECT_EQ(pressed(), std::optional(true));
  results.is_stale = true;  // and begins again soon
  frame();
  EXPECT_TRUE(has("measure/Stop"));
  results = {};
  frame();
  EXPECT_TRUE(has("measure/Measure"));
}

TEST_F(Accuracy, SaysPlainlyWhichSettingKeepsTheTargetOrThatNoneDoes) {
  // dvr has an error of 0.001 at 1/4
  EXPECT_TRUE(
      has("verdict: Fastest that keeps share=0.001: DVR, equal steps, rounded up at step 1/4, 40 ms"));
  type("##target error", "0.0005");
  EXPECT_TRUE(
      has("verdict: No setting measured keeps share=0.0005: the closest is DVR, equal steps, rounded "
          "up at step 1/4 (share 0.001)"));
  results.is_running = true;
  frame();
  EXPECT_TRUE(
      has("verdict: No setting measured so far keeps share=0.0005: the closest is DVR, equal steps, "
          "rounded up at step 1/4 (share 0.001)"));
  results.is_stale = true;
  frame();
  for (const auto& [name, rect] : state->widgets.items) EXPECT_FALSE(name.starts_with("verdict")) << name;
}

TEST_F(Accuracy, TellsWhoseAnswerIsShownAndHowFarItIsFromTheIntegral) {
  EXPECT_TRUE(
      has("model: The exact answer of \"Volume\": the integral, from which the others are told apart"));
  click("answer/base+crossings");
  EXPECT_TRUE(has("model: The exact answer of \"Surfaces + volume\""));
  ImageError difference;
  difference.compared.pixels = 1000;
  difference.compared.share = 0.123;
  results.model_differences.push_back({Answer::base_and_crossings, difference});
  frame();
  EXPECT_TRUE(
      has("model: The exact answer of \"Surfaces + volume\" differs from the integral in 12 % of the pixels: "
          "that is the "
          "mode, not an error"));
  click("answer/crossings");
  EXPECT_TRUE(has("model: The exact answer of \"Surfaces\""));
  click("answer/integral+crossings");
  EXPECT_TRUE(has("model: The exact answer of \"Surfaces + whole volume\""));
}

TEST_F(Accuracy, NothingMeasuredLeavesAHintAndNoPoints) {
  inputs.accuracy = nullptr;
  frames(2);
  EXPECT_TRUE(has("accuracy plot"));
  EXPECT_FALSE(has("method/dvr"));
  const Document before = document;
  click("accuracy plot");
  EXPECT_EQ(document, before);
}

TEST_F(Accuracy, NumbersOfAnyKind) {
  const double infinity = std::numeric_limits<double>::infinity();
  results.measured.clear();
  add("dvr", 1, 10, 0);
  add("dvr", 0.5, 20, 0);
  add("dvr-eye", 1, 10, std::nan(""));
  add("dvr-eye", 0.5, 0, 1);
  add("dvr-entry", 0.5, infinity, 1);
  add("gone", 0.5, 10, 0.1);
  frames(2);
  EXPECT_TRUE(has("measured/dvr/1")) << "an error of 0 has a place below the axis";
  EXPECT_EQ(place("dvr/1").y, place("dvr/0.5").y);
  EXPECT_FALSE(has("measured/dvr-eye/1"));
  EXPECT_FALSE(has("measured/dvr-eye/0.5"));
  EXPECT_FALSE(has("measured/dvr-entry/0.5"));
  type("##target error", "0");
  click(place("dvr/1"));
  EXPECT_EQ(rendering().step, 1);
}

TEST_F(Accuracy, SmallWindows) {
  for (const ImVec2 size : {ImVec2{1000, 700}, {640, 400}, {200, 150}, {70, 70}, {1000, 700}}) {
    ImGui::GetIO().DisplaySize = size;
    frames(3);
    if (size.x < 1000) continue;
    EXPECT_LT(place("dvr/0.25").x, size.x);
    EXPECT_LT(place("dvr/0.25").y, size.y);
  }
  click(place("dvr/0.25"));
  EXPECT_EQ(rendering().step, 0.25);
}

TEST(AccuracyPlot, APointBetweenTwoSteps) {
  std::vector<Measurement> measured;
  for (const double step : {1.0, 0.25})
    measured.push_back(crest::testing::measurement("dvr", step, 8 / step, step * step));
  const auto lines = method_lines(measured, Answer::integral, *default_target().measure);
  ASSERT_EQ(lines.size(), 1U);
  const auto at = [&](double step) { return point_at_step(lines[0], measured, step); };
  EXPECT_EQ(at(1)->ms, 8);
  EXPECT_EQ(at(0.25)->error, 0.0625);
  EXPECT_NEAR(at(0.5)->ms, 16, 1e-12);
  EXPECT_NEAR(at(0.5)->error, 0.25, 1e-12);
  EXPECT_FALSE(at(2));
  EXPECT_FALSE(at(0.1));
}

}  // namespace
}  // namespace crest::test
