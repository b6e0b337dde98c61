#include "app/background_choice.h"

#include <gtest/gtest.h>

#include <atomic>

#include "presets/error.h"
#include "tests/measure/scenes.h"

namespace crest {
namespace {

using namespace std::chrono_literals;

/// A choice that takes until it is let go, or stopped.
struct FakeChoice {
  std::atomic<bool> goes_on = true, fails = false;
  std::atomic<int> calls = 0;

  std::optional<Choice> operator()(const SweepSubject& subject, std::stop_token stop) {
    ++calls;
    while (goes_on && !stop.stop_requested()) std::this_thread::sleep_for(1ms);
    if (stop.stop_requested()) return std::nullopt;
    if (fails) throw Error("no luck");
    Choice choice;
    choice.setting.method = find_method("dvr-pre");
    choice.rendering = with_method(subject.scene.rendering, *choice.setting.method, 0.25);
    return choice;
  }
};

class BackgroundChoiceTest : public ::testing::Test {
 protected:
  BackgroundChoiceTest() {
    subject.scene = testing::scene_with_peak(0.5);
    subject.size = {8, 8};
  }
  /// What take() gives once it is done.
  std::optional<Rendering> taken() {
    for (int i = 0; i < 12000 && !choice.has_news(); ++i) std::this_thread::sleep_for(5ms);
    return choice.take(subject);
  }

  FakeChoice fake;
  SweepSubject subject;
  BackgroundChoice choice{
      [this](const SweepSubject& s, const ChoiceSettings&, std::stop_token stop) { return fake(s, stop); }};
};

TEST_F(BackgroundChoiceTest, IsTakenOnce) {
  const ChoiceSettings settings{.target = parse_target("rmse=0.01")};
  choice.start(subject, settings);
  EXPECT_TRUE(choice.is_running());
  EXPECT_FALSE(choice.take(subject));
  choice.start(subject, settings);  // one at a time
  fake.goes_on = false;
  const auto rendering = taken();
  ASSERT_TRUE(rendering);
  EXPECT_EQ(rendering->step, 0.25);
  EXPECT_FALSE(choice.is_running());
  EXPECT_FALSE(choice.take(subject));
  EXPECT_EQ(fake.calls, 1);
  EXPECT_EQ(to_string(choice.results().target), "rmse=0.01");
  EXPECT_EQ(choice.results().chosen->rendering, *rendering);
  EXPECT_EQ(choice.results().error, "");
}

TEST_F(BackgroundChoiceTest, IsNotTakenForAnotherScene) {
  choice.start(subject, {});
  subject.scene.tf.points.front().opacity = 0.25;
  fake.goes_on = false;
  EXPECT_FALSE(taken());
  EXPECT_FALSE(choice.is_running());
  EXPECT_FALSE(choice.results().chosen);
  EXPECT_NE(choice.results().error.find("choose again"), std::string::npos);

  choice.start(subject, {});
  subject.size = {16, 8};  // the window was dragged
  EXPECT_TRUE(taken());
}

TEST_F(BackgroundChoiceTest, IsStopped) {
  choice.start(subject, {});
  choice.stop();
  EXPECT_FALSE(taken());
  EXPECT_FALSE(choice.is_running());
  EXPECT_EQ(choice.results().error, "");
}

// Pressed when it was done, but not yet taken.
TEST_F(BackgroundChoiceTest, WhatIsStoppedLateIsNotTaken) {
  fake.goes_on = false;
  choice.start(subject, {});
  while (!choice.has_news()) std::this_thread::yield();
  choice.stop();
  EXPECT_FALSE(choice.take(subject));
  EXPECT_FALSE(choice.results().chosen);
  EXPECT_EQ(choice.results().error, "");
}

TEST_F(BackgroundChoiceTest, EndsWhereTheSceneChanges) {
  choice.start(subject, {});
  choice.update(subject);
  EXPECT_FALSE(choice.has_news());
  subject.camera.fov_y_degrees += 1;
  choice.update(subject);  // else it goes on for ever
  EXPECT_FALSE(taken());
  EXPECT_NE(choice.results().error.find("choose again"), std::string::npos);
}

TEST_F(BackgroundChoiceTest, ItsErrorIsTold) {
  fake.goes_on = false;
  fake.fails = true;
  choice.start(subject, {});
  EXPECT_FALSE(taken());
  EXPECT_EQ(choice.results().error, "no luck");
  fake.fails = false;
  choice.start(subject, {});
  EXPECT_TRUE(taken());
  EXPECT_EQ(choice.results().error, "");
}

TEST(BackgroundChoice, EndsWithTheWindowWhileItRuns) {
  FakeChoice endless;
  BackgroundChoice choice(
      [&](const SweepSubject& s, const ChoiceSettings&, std::stop_token stop) { return endless(s, stop); });
  SweepSubject subject;
  subject.scene = testing::scene_with_peak(0.5);
  choice.start(subject, {});
}

TEST(BackgroundChoice, ChoosesOffscreen) {
  SweepSubject subject;
  subject.scene = testing::scene_with_peak(0.5);
  subject.scene.rendering.mode = Mode::peak_xor_dvr;
  subject.camera.eye = {0.5, -3, 0.5};
  subject.camera.target = {0.5, 0.5, 0.5};
  subject.camera.up = {0, 0, 1};
  subject.size = {48, 32};
  const auto choice = choose_offscreen(subject, {}, {});
  ASSERT_TRUE(choice);
  EXPECT_TRUE(choice->meets_target);
  EXPECT_EQ(choice->rendering.mode, Mode::peak_xor_dvr);
}

}  // namespace
}  // namespace crest
