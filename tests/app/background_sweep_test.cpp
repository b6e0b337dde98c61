#include "app/background_sweep.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <thread>

#include "presets/error.h"
#include "tests/measure/pictures.h"
#include "tests/measure/scenes.h"

namespace crest {
namespace {

using namespace std::chrono_literals;
using Clock = BackgroundSweep::Clock;

/// A renderer without a device: frames take `frame_time` of real time, exact answers until they are stopped
/// if `endless`.
struct FakeRenderer {
  std::atomic<int> renderers = 0, sweeps = 0, frames = 0, references = 0;
  std::atomic<bool> endless = false;
  std::chrono::milliseconds frame_time{0};

  SweepRenderer operator()() {
    ++renderers;
    return {"fake", [this](const SweepSubject& subject) {
              ++sweeps;
              Measurer m;
              m.seconds = [] { return 0.0; };
              m.reference = [this, size = subject.size](const ExactAnswer&, const Progress& progress) {
                ++references;
                do {
                  if (!progress(0.5)) throw Cancelled{};
                  std::this_thread::sleep_for(1ms);
                } while (endless);
                return testing::as_exact(testing::filled(size, glm::vec4(0.5f)));
              };
              m.start = [](const Rendering&) { return Measurer::Start{}; };
              m.picture = [size = subject.size](const Rendering& r) {
                Measurer::Picture picture;
                picture.image = testing::filled(size, glm::vec4(float(0.5 + 0.01 * r.step)));
                return picture;
              };
              m.frame = [this](const Rendering& r) {
                ++frames;
                std::this_thread::sleep_for(frame_time);
                return Measurer::FrameTime{1 / r.step, 1 / r.step};
              };
              return m;
            }};
  }
};

class BackgroundSweepTest : public ::testing::Test {
 protected:
  BackgroundSweepTest() {
    subject.scene = testing::scene_with_peak(0.5);
    subject.size = {8, 8};
  }

  /// Until it is true, at most a minute: a busy machine takes some seconds.
  template <class Condition>
  static bool wait_for(Condition condition) {
    for (int i = 0; i < 12000; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(5ms);
    }
    return false;
  }
  bool wait_for_points(std::size_t count) {
    return wait_for([&] {
      const auto& results = sweep.results();
      return !results.is_stale && results.measured.size() >= count;
    });
  }

  FakeRenderer renderer;
  SweepSubject subject;
  Clock::time_point now = Clock::now();
  BackgroundSweep sweep{[this] { return renderer(); }};
};

TEST_F(BackgroundSweepTest, DoesNothingBeforeItIsSwitchedOn) {
  sweep.update(subject, now);
  sweep.update(subject, now + 1h);
  std::this_thread::sleep_for(20ms);
  EXPECT_FALSE(sweep.is_active());
  EXPECT_FALSE(sweep.results().is_on);
  EXPECT_EQ(renderer.renderers, 0);
}

TEST_F(BackgroundSweepTest, MeasuresEveryPointAndRests) {
  sweep.update(subject, now);
  sweep.switch_on();
  EXPECT_TRUE(sweep.is_active());
  ASSERT_TRUE(wait_for([&] { return !sweep.results().is_running; }));
  const AccuracyResults& results = sweep.results();
  std::size_t points = 0;
  for (const Method& method : methods()) points += method.has_step ? sweep_steps().size() : 1;
  EXPECT_EQ(results.measured.size(), points);
  EXPECT_EQ(results.renderer, "fake");
  std::set<ExactAnswer> others;  // the fake one's answers are all the same picture
  for (const AnswerError& difference : results.model_differences) {
    EXPECT_TRUE(others.insert(difference.answer).second);
    EXPECT_EQ(difference.error.compared.share, 0);
  }
  EXPECT_TRUE(others.contains(Answer::base_and_crossings));
  EXPECT_FALSE(others.contains(Answer::integral));
  EXPECT_EQ(results.size, subject.size);
  EXPECT_EQ(results.error, "");
  EXPECT_TRUE(results.is_on);
  EXPECT_FALSE(sweep.is_active());
  EXPECT_FALSE(sweep.has_news(now + 1h));
}

TEST_F(BackgroundSweepTest, WhatIsLeftIsMeasuredNoMore) {
  renderer.endless = true;
  const std::weak_ptr<const Volume> volume = subject.scene.volume;
  sweep.update(subject, now);
  sweep.switch_on();
  ASSERT_TRUE(wait_for([&] { return renderer.references == 1; }));
  subject.scene.volume.reset();
  sweep.leave();
  EXPECT_FALSE(sweep.is_active());
  EXPECT_TRUE(wait_for([&] { return volume.expired(); })) << "nobody holds the volume";
  EXPECT_TRUE(sweep.results().is_on) << "of the next one";
}

TEST_F(BackgroundSweepTest, WhatTheSweepVariesDoesNotBeginItAgain) {
  sweep.update(subject, now);
  sweep.switch_on();
  ASSERT_TRUE(wait_for_points(1));
  Rendering& rendering = subject.scene.rendering;
  rendering.mode = Mode::peak_only;
  rendering.peak_form = PeakForm::paper;
  rendering.step = 0.125;
  rendering.placement = Placement::eye;
  rendering.shading = Shading::gradient;
  rendering.early_termination = 0.01;
  sweep.update(subject, now + 1h);
  EXPECT_FALSE(sweep.results().is_stale);
  ASSERT_TRUE(wait_for([&] { return !sweep.results().is_running; }));
  EXPECT_EQ(renderer.sweeps, 1);
}

TEST_F(BackgroundSweepTest, WhatItMeasuresBeginsItAgain) {
  sweep.update(subject, now);
  sweep.switch_on();
  const std::vector<std::function<void(SweepSubject&)>> changes{
      [](SweepSubject& s) { s.scene.tf.points[1].opacity = 0.25; },
      [](SweepSubject& s) { s.scene.volume = std::make_shared<Volume>(*s.scene.volume); },
      [](SweepSubject& s) { s.camera.eye.x += 1; },
      [](SweepSubject& s) { s.size.x += 8; },
      [](SweepSubject& s) { s.scene.rendering.clip_box = ClipBox{}; },
      [](SweepSubject& s) { s.scene.rendering.max_peaks = 2; },
  };
  int sweeps = 1;
  for (const auto& change : changes) {
    ASSERT_TRUE(wait_for_points(1));
    EXPECT_EQ(renderer.sweeps, sweeps);
    change(subject);
    now += 1h;
    sweep.update(subject, now);
    EXPECT_TRUE(sweep.results().is_stale);
    sweep.update(subject, now + BackgroundSweep::pause);
    ++sweeps;
    ASSERT_TRUE(wait_for([&] { return renderer.sweeps == sweeps; })) << "change " << sweeps - 1;
  }
}

TEST_F(BackgroundSweepTest, BeginsAgainOnlyAfterAPauseWithoutChanges) {
  sweep.update(subject, now);
  sweep.switch_on();
  ASSERT_TRUE(wait_for([&] { return !sweep.results().is_running; }));
  for (int i = 0; i < 20; ++i) {  // a drag of several pauses' length
    subject.camera.eye.x += 1;
    now += BackgroundSweep::pause / 2;
    sweep.update(subject, now);
    EXPECT_TRUE(sweep.is_active());
    EXPECT_FALSE(sweep.results().is_running);
  }
  now += BackgroundSweep::pause - 1ms;
  sweep.update(subject, now);
  EXPECT_FALSE(sweep.results().is_running);
  EXPECT_FALSE(sweep.has_news(now));
  EXPECT_TRUE(sweep.has_news(now + 1ms));
  sweep.update(subject, now + 1ms);
  EXPECT_TRUE(sweep.results().is_running);
}

TEST_F(BackgroundSweepTest, AChangeThatIsTakenBackCostsNothing) {
  sweep.update(subject, now);
  sweep.switch_on();
  ASSERT_TRUE(wait_for_points(1));
  SweepSubject other = subject;
  other.camera.eye.x += 1;
  sweep.update(other, now + 1s);
  sweep.update(subject, now + 1100ms);
  sweep.update(subject, now + 1h);
  EXPECT_FALSE(sweep.results().is_stale);
  EXPECT_EQ(renderer.sweeps, 1);
}

TEST_F(BackgroundSweepTest, OldPointsStayUntilTheFirstNewOne) {
  sweep.update(subject, now);
  sweep.switch_on();
  ASSERT_TRUE(wait_for([&] { return !sweep.results().is_running; }));
  const std::size_t count = sweep.results().measured.size();
  renderer.endless = true;
  subject.camera.eye.x += 1;
  now += 1h;
  sweep.update(subject, now);
  sweep.update(subject, now + 1h);
  ASSERT_TRUE(wait_for([&] { return renderer.sweeps == 2; }));
  EXPECT_TRUE(sweep.results().is_running);
  EXPECT_TRUE(sweep.results().is_stale);
  EXPECT_EQ(sweep.results().measured.size(), count);
  renderer.endless = false;
  ASSERT_TRUE(wait_for([&] { return !sweep.results().is_stale; }));
  EXPECT_LT(sweep.results().measured.size(), count);
}

TEST_F(BackgroundSweepTest, StopsWithinAnExactAnswer) {
  renderer.endless = true;
  sweep.update(subject, now);
  sweep.switch_on();
  ASSERT_TRUE(wait_for([&] { return renderer.references == 1; }));
  sweep.switch_off();
  EXPECT_FALSE(sweep.results().is_running);
  EXPECT_FALSE(sweep.is_active());
  renderer.endless = false;
  sweep.switch_on();  // the thread is free again
  EXPECT_TRUE(wait_for_points(1));
}

TEST_F(BackgroundSweepTest, StopsWithinAGroupAndKeepsWhatItHas) {
  renderer.frame_time = 2ms;
  sweep.update(subject, now);
  sweep.switch_on();
  ASSERT_TRUE(wait_for_points(3));
  const auto before = Clock::now();
  sweep.switch_off();
  EXPECT_LT(Clock::now() - before, 1s) << "it does not wait for the thread";
  const std::size_t count = sweep.results().measured.size();
  EXPECT_GE(count, 3u);
  std::this_thread::sleep_for(50ms);
  const int frames = renderer.frames;
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(renderer.frames, frames);
  EXPECT_EQ(sweep.results().measured.size(), count);
  EXPECT_FALSE(sweep.results().is_on);
}

TEST_F(BackgroundSweepTest, EndsWhileItMeasures) {
  renderer.endless = true;
  {
    BackgroundSweep other([this] { return renderer(); });
    other.update(subject, now);
    other.switch_on();
    ASSERT_TRUE(wait_for([&] { return renderer.references == 1; }));
  }
  EXPECT_EQ(renderer.sweeps, 1);
}

TEST_F(BackgroundSweepTest, RestsWhileThePersonDoesSomething) {
  sweep.rest_until(Clock::now() + 1h);
  sweep.update(subject, now);
  sweep.switch_on();
  ASSERT_TRUE(wait_for([&] { return renderer.references == 1; }));
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(renderer.frames, 0);
  EXPECT_TRUE(sweep.results().measured.empty());
  sweep.switch_off();  // and can be stopped at rest
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(renderer.references, 1);
}

TEST_F(BackgroundSweepTest, AfterARestItGoesOn) {
  sweep.rest_until(Clock::now() + 100ms);
  sweep.update(subject, now);
  const auto begin = Clock::now();
  sweep.switch_on();
  ASSERT_TRUE(wait_for_points(1));
  EXPECT_GT(Clock::now() - begin, 90ms);
}

TEST_F(BackgroundSweepTest, ARendererThatFailsIsTold) {
  BackgroundSweep broken([]() -> SweepRenderer { throw Error("no graphics driver here"); });
  broken.update(subject, now);
  broken.switch_on();
  ASSERT_TRUE(wait_for([&] { return !broken.results().is_running; }));
  EXPECT_EQ(broken.results().error, "no graphics driver here");
  EXPECT_FALSE(broken.is_active());
}

TEST(SweepSize, KeepsTheShapeInAFewPixels) {
  EXPECT_EQ(sweep_size({540, 500}), glm::ivec2(256, 240));
  EXPECT_EQ(sweep_size({541, 503}), glm::ivec2(256, 240)) << "some pixels more are the same subject";
  EXPECT_EQ(sweep_size({100, 900}), glm::ivec2(32, 256));
  EXPECT_EQ(sweep_size({1, 1}), glm::ivec2(8, 8));
}

// The real thing: the ray caster off-screen, beside this thread.
TEST(OffscreenSweep, MeasuresAScene) {
  SweepSubject subject;
  subject.scene = testing::scene_with_peak(0.5);
  subject.camera = {{3, 2, 4}, {0.5, 0.5, 0.5}, {0, 1, 0}, 30, Projection::perspective, {}};
  subject.size = {16, 16};
  BackgroundSweep sweep;
  sweep.update(subject, Clock::now());
  sweep.switch_on();
  for (int i = 0; i < 24000 && sweep.results().measured.size() < 4 && sweep.results().is_running; ++i)
    std::this_thread::sleep_for(5ms);
  const AccuracyResults results = sweep.results();
  ASSERT_EQ(results.error, "");
  ASSERT_GE(results.measured.size(), 4u);
  EXPECT_NE(results.renderer.find("OpenGL"), std::string::npos);
  for (const Measurement& m : results.measured) {
    EXPECT_GT(m.frame_ms, 0);
    EXPECT_GT(m.samples_per_ray, 0);
    ASSERT_FALSE(m.errors.empty());
    EXPECT_GT(m.errors[0].error.compared.pixels, 20u);
    EXPECT_LT(m.errors[0].error.compared.rmse, 0.2);
  }
}

}  // namespace
}  // namespace crest
