#include <fmt/core.h>

#include "tests/ui/harness.h"
#include "ui/actions.h"

namespace crest::test {
namespace {

class TimeStepRow : public Studio {
 protected:
  void show(ShownSteps steps) {
    inputs.steps = steps;
    frames(3);
  }
};

TEST_F(TimeStepRow, StandsThereForAVolumeThatHasSome) {
  frames(3);
  EXPECT_FALSE(has("step slider"));
  const int height = requests.view_pixels[0].y;
  show({20, 3, 3, 20, false});
  EXPECT_TRUE(has("step slider"));
  EXPECT_LT(requests.view_pixels[0].y, height) << "the views make room";
  EXPECT_GT(requests.view_pixels[0].y, height - 40);
}

TEST_F(TimeStepRow, ButtonsAndKeysGoByOne) {
  show({20, 3, 3, 20, false});
  EXPECT_EQ(press_on("next step").go_to_step, 4);
  EXPECT_EQ(press_on("previous step").go_to_step, 2);
  EXPECT_EQ(key('.').go_to_step, 4);
  EXPECT_EQ(key(',').go_to_step, 2);
  show({20, 3, 7, 20, false});
  EXPECT_EQ(key('.').go_to_step, 8) << "from the one that was asked for last";
  show({20, 19, 19, 20, false});
  EXPECT_EQ(key('.').go_to_step, 19) << "there is no further one";
  EXPECT_FALSE(requests.document_changed) << "a step is no edit";
}

TEST_F(TimeStepRow, TheSliderTakesAnyAndTheFieldANumber) {
  show({21, 0, 0, 21, false});
  const auto [least, most] = state->widgets.items.at("step slider");
  move_to({(least.x + most.x) / 2, (least.y + most.y) / 2});
  press();
  EXPECT_EQ(requests.go_to_step, 10);
  release();
  move_to({most.x - 2, (least.y + most.y) / 2});
  press();
  EXPECT_EQ(requests.go_to_step, 20);
  release();
  click("##time step");
  ctrl('A');
  for (const char digit : {'1', '7'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(digit));
  frames(2);
  EXPECT_EQ(key_of(ImGuiKey_Enter).go_to_step, 17);
}

TEST_F(TimeStepRow, PlaysAndStops) {
  show({20, 3, 3, 20, false});
  EXPECT_EQ(press_on("play steps").play_steps, true);
  EXPECT_EQ(key('T').play_steps, true);
  show({20, 3, 3, 20, true});
  EXPECT_EQ(press_on("play steps").play_steps, false);
  EXPECT_EQ(key('T').play_steps, false);
}

TEST_F(TimeStepRow, ItsActionsSayWhyTheyCannot) {
  const ActionContext context{document, *state, inputs, requests};
  for (const char* name : {"Previous time step", "Next time step", "Play time steps"})
    EXPECT_EQ(why_not(action_named(name), context), "the volume has no time steps");
  EXPECT_FALSE(key('.').go_to_step);
  EXPECT_FALSE(key('T').play_steps);
}

}  // namespace
}  // namespace crest::test
