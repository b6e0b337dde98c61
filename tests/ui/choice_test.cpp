#include "render/measure/methods.h"
#include "tests/measure/measurements.h"
#include "tests/ui/harness.h"
#include "ui/choice_rows.h"

namespace crest::test {
namespace {

class ChooseForMe : public Studio {
 protected:
  ChooseForMe() {
    document.preset.rendering.mode = Mode::dvr_only;
    inputs.choice = &results;
    click("tab/Rendering");
  }
  StudioRequests pressed() {
    move_to(center_of("choose"));
    press();
    release();
    return requests;
  }
  /// As the program does when the choice is done.
  void choose(bool meets_target) {
    Choice choice;
    choice.setting.method = find_method("dvr-pre");
    choice.setting.step = 0.25;
    choice.setting.error = {.rays = 5000, .value = 0.0002, .low = 0, .high = 0.0009};
    choice.setting.frame_ms = 42;
    choice.meets_target = meets_target;
    choice.why = "of 7 tried";
    choice.rendering = with_method(document.preset.rendering, *choice.setting.method, 0.25);
    results.chosen = choice;
    document.preset.rendering = choice.rendering;
  }

  ChoiceResults results;
};

TEST_F(ChooseForMe, AsksForTheAccuracyPanelsTarget) {
  state->accuracy.target = parse_target("rmse=0.01");
  const StudioRequests asked = pressed();
  ASSERT_TRUE(asked.choose);
  EXPECT_EQ(to_string(*asked.choose), "rmse=0.01");
  EXPECT_FALSE(asked.stop_choosing);
  frame();
  EXPECT_FALSE(requests.choose) << "it is asked for once";
}

TEST_F(ChooseForMe, IsStoppedWhileItRuns) {
  results.is_running = true;
  const StudioRequests asked = pressed();
  EXPECT_TRUE(asked.stop_choosing);
  EXPECT_FALSE(asked.choose);
}

TEST_F(ChooseForMe, NeedsAVolume) {
  inputs.volume = nullptr;
  EXPECT_FALSE(pressed().choose);
}

TEST_F(ChooseForMe, OneUndoTakesItBack) {
  frames(2);
  const Document before = document;
  choose(true);
  frames(2);
  EXPECT_NE(document, before);
  EXPECT_TRUE(has("chosen"));
  ctrl('Z');
  EXPECT_EQ(document, before);
  frame();
  EXPECT_FALSE(has("chosen")) << "of what is not there it does not tell";
}

TEST_F(ChooseForMe, TellsWhereNothingMeetsTheTarget) {
  choose(false);
  frame();
  EXPECT_TRUE(has("chosen, target missed"));
  EXPECT_FALSE(has("chosen"));
  results.error = "no point of the transfer function has an opacity";
  frame();
  EXPECT_TRUE(has("choice error"));
}

TEST_F(ChooseForMe, TellsWhatIsForetoldAndWhatIsMeasured) {
  EXPECT_EQ(choice_text(results, nullptr), "");
  choose(true);
  const std::string foretold = choice_text(results, nullptr);
  EXPECT_EQ(foretold,
            "DVR, pre-integrated at step 1/4: of 7 tried.\n"
            "Predicted share 0.0002, at most 0.0009, and 42 ms a frame.");
  AccuracyResults accuracy;
  accuracy.size = {256, 240};
  accuracy.measured.push_back(crest::testing::measurement("dvr-pre", 0.5, 9, 0.5));
  EXPECT_EQ(choice_text(results, &accuracy), foretold) << "of another step";
  accuracy.measured.push_back(crest::testing::measurement("dvr-pre", 0.25, 12, 0.0003));
  EXPECT_EQ(choice_text(results, &accuracy),
            foretold + "\nMeasured share 0.0003, and 12 ms a frame of 256 x 240 pixels.");
  accuracy.is_stale = true;
  EXPECT_EQ(choice_text(results, &accuracy), foretold);
}

}  // namespace
}  // namespace crest::test
