#include "app/time_steps.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#include "presets/error.h"

namespace crest::test {
namespace {

using namespace std::chrono_literals;

/// Step i of "film" has the values i and 10 i + 1. A step is read when it is let through; counts what is
/// read.
class Film {
 public:
  explicit Film(int frames) : frames_(frames) {}

  std::shared_ptr<const Volume> first() const { return std::make_shared<const Volume>(step(0)); }
  VolumeLoader::Read read() {
    return [this](const std::string& source, const Reading& reading) {
      const int frame = std::stoi(source.substr(source.rfind('=') + 1));
      std::unique_lock lock(mutex_);
      ++begun_[frame];
      changed_.notify_all();
      changed_.wait(lock, [&] { return open_ || passes_.contains(frame) || reading.stop.stop_requested(); });
      if (damaged_ == frame) throw Error("film: step is damaged");
      return step(frame);
    };
  }
  void open() {
    change([&] { open_ = true; });
  }
  void let_through(int frame) {
    change([&] { passes_[frame] = true; });
  }
  void damage(int frame) {
    change([&] { damaged_ = frame; });
  }
  void wait_until_begun(int frame) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return begun_[frame] > 0; });
  }
  int begun(int frame) {
    const std::scoped_lock lock(mutex_);
    return begun_[frame];
  }

 private:
  template <class Change>
  void change(Change change) {
    const std::scoped_lock lock(mutex_);
    change();
    changed_.notify_all();
  }
  Volume step(int frame) const {
    Volume volume;
    volume.grid.dims = {2, 2, 2};
    volume.values = std::vector<float>(8, float(frame));
    volume.values.floats()[7] = float(10 * frame + 1);
    volume.statistics = compute_statistics(volume.grid, volume.values);
    volume.frames = frames_;
    volume.frame = frame;
    return volume;
  }
  const int frames_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<int, int> begun_;
  std::map<int, bool> passes_;
  int damaged_ = -1;
  bool open_ = false;
};

class TimeStepsTest : public ::testing::Test {
 protected:
  ~TimeStepsTest() override {
    film.open();
    steps.open("", nullptr);
    while (steps.has_thread()) std::this_thread::sleep_for(1ms);  // which use the film
  }
  void begin() { steps.open("film", film.first()); }
  /// Updates until there is news.
  TimeSteps::News news() {
    while (true) {
      if (auto news = steps.update(now)) return *news;
      std::this_thread::sleep_for(1ms);
    }
  }
  /// Updates until nothing is left to do; returns the last that was to be shown.
  TimeSteps::SharedVolume settle() {
    TimeSteps::SharedVolume last;
    do {
      if (auto news = steps.update(now); news && news->volume) last = news->volume;
      std::this_thread::sleep_for(1ms);
    } while (steps.is_active());
    return last;
  }
  void update_until_begun(int frame) {
    while (film.begun(frame) == 0) {
      EXPECT_FALSE(steps.update(now));
      std::this_thread::sleep_for(1ms);
    }
  }

  Film film{5};
  TimeSteps steps{film.read()};
  TimeSteps::Clock::time_point now = TimeSteps::Clock::now();
};

TEST_F(TimeStepsTest, OfAPlainVolumeAreNone) {
  steps.open("plain", std::make_shared<const Volume>());
  EXPECT_EQ(steps.count(), 1);
  steps.go_to(3);
  steps.play(true);
  EXPECT_FALSE(steps.update(now));
  EXPECT_FALSE(steps.is_active());
  EXPECT_EQ(steps.wanted(), 0);
}

TEST_F(TimeStepsTest, WhatIsShownStaysUntilTheOneThatWasAskedForLastIsThere) {
  begin();
  steps.go_to(2);
  EXPECT_FALSE(steps.update(now));
  film.wait_until_begun(2);
  steps.go_to(4);
  EXPECT_FALSE(steps.update(now)) << "no call waits";
  film.wait_until_begun(4);
  EXPECT_EQ(steps.shown(), 0);
  EXPECT_EQ(steps.wanted(), 4);
  film.let_through(2);
  film.let_through(4);
  const auto told = news();
  ASSERT_TRUE(told.volume);
  EXPECT_EQ(told.volume->frame, 4);
  EXPECT_EQ(steps.shown(), 4);
}

TEST_F(TimeStepsTest, TheNextOneIsHeldAheadAndShownAtOnce) {
  begin();
  film.let_through(1);
  update_until_begun(1);
  update_until_begun(2);  // step 1 is held, and the others are read for their range
  EXPECT_EQ(steps.shown(), 0);
  steps.go_to(1);
  EXPECT_EQ(news().volume->frame, 1);
  EXPECT_EQ(film.begun(1), 1) << "it is read once";
}

TEST_F(TimeStepsTest, TravelBackReadsTheOneBefore) {
  film.open();
  begin();
  steps.go_to(3);
  EXPECT_EQ(settle()->frame, 3);
  const int before = film.begun(1);
  steps.go_to(2);
  EXPECT_EQ(settle()->frame, 2);
  EXPECT_EQ(film.begun(1), before + 1);
}

TEST_F(TimeStepsTest, TheRangeIsThatOfAllOfThem) {
  begin();
  EXPECT_EQ(steps.known_ranges(), 1);
  film.open();
  const auto wide = settle();
  ASSERT_TRUE(wide) << "the shown one, in the range that was found";
  EXPECT_EQ(wide->frame, 0);
  EXPECT_EQ(wide->statistics.range, (ValueRange{0, 41}));
  EXPECT_EQ(wide->values, film.first()->values);
  EXPECT_TRUE(steps.has_whole_range());
  for (int i = 1; i < 5; ++i) EXPECT_EQ(film.begun(i), 1) << i;
  steps.go_to(1);
  const auto told = news();
  EXPECT_EQ(told.volume->frame, 1);
  EXPECT_EQ(told.volume->statistics.range, (ValueRange{0, 41})) << "at once, not in one of its own before";
  steps.go_to(4);
  EXPECT_EQ(news().volume->statistics.range, (ValueRange{0, 41}));
}

TEST_F(TimeStepsTest, ADamagedOneIsToldWhenItIsWantedAlone) {
  film.damage(3);
  film.open();
  begin();
  settle();
  EXPECT_EQ(steps.known_ranges(), 4);
  steps.go_to(3);
  const auto told = news();
  EXPECT_EQ(told.error, "film: step is damaged");
  EXPECT_FALSE(told.volume);
  EXPECT_EQ(steps.wanted(), 0) << "the shown one stays";
  steps.go_to(4);
  EXPECT_EQ(settle()->frame, 4);
}

TEST_F(TimeStepsTest, PlayingTakesEachAndBeginsAnew) {
  film.open();
  begin();
  settle();
  steps.play(true);
  std::vector<int> seen;
  while (seen.size() < 6) {
    const auto told = news();
    ASSERT_TRUE(told.volume);
    seen.push_back(told.volume->frame);
    for (int i = 0; i < 20; ++i) {
      EXPECT_FALSE(steps.update(now)) << "not before its time";
      std::this_thread::sleep_for(1ms);
    }
    now += TimeSteps::pause;
  }
  EXPECT_EQ(seen, (std::vector<int>{1, 2, 3, 4, 0, 1}));
  steps.play(false);
  EXPECT_FALSE(steps.is_playing());
  settle();
  EXPECT_EQ(steps.shown(), 1);
}

TEST_F(TimeStepsTest, PlayingEndsAtADamagedOne) {
  film.damage(2);
  film.open();
  begin();
  settle();
  steps.play(true);
  EXPECT_EQ(news().volume->frame, 1);
  now += TimeSteps::pause;
  EXPECT_EQ(news().error, "film: step is damaged");
  EXPECT_FALSE(steps.is_playing());
  EXPECT_EQ(steps.shown(), 1);
}

TEST_F(TimeStepsTest, AnotherVolumeEndsThem) {
  begin();
  steps.go_to(2);
  steps.update(now);
  film.wait_until_begun(2);
  steps.open("other", std::make_shared<const Volume>());
  film.open();
  EXPECT_EQ(settle(), nullptr);
  EXPECT_EQ(steps.shown(), 0);
  EXPECT_FALSE(steps.is_active());
}

}  // namespace
}  // namespace crest::test
