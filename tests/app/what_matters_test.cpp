#include "app/what_matters.h"

#include <gtest/gtest.h>

#include <atomic>

#include "presets/error.h"
#include "render/volume/builtin.h"
#include "tests/measure/scenes.h"

namespace crest {
namespace {

using namespace std::chrono_literals;

/// Measurements that take until they are let go, or stopped.
struct FakeWork {
  std::atomic<bool> goes_on = false, fails = false;
  std::atomic<int> begun = 0, stopped = 0;

  bool wait(const std::stop_token& stop) {
    ++begun;
    while (goes_on && !stop.stop_requested()) std::this_thread::sleep_for(1ms);
    if (stop.stop_requested()) ++stopped;
    if (fails) throw Error("no luck");
    return !stop.stop_requested();
  }
};

class WhatMattersTest : public ::testing::Test {
 protected:
  WhatMattersTest() {
    subject.scene = testing::scene_with_peak(0.5);
    subject.size = {8, 8};
  }
  /// Waits until there is news of a thread; update() sees a picture that is at rest.
  void settle() {
    for (int i = 0; i < 12000 && !matters.has_news(now); ++i) std::this_thread::sleep_for(5ms);
    matters.take();
  }
  void update() { matters.update(subject, true, now); }
  void update_after_pause() {
    update();
    now += WhatMatters::pause;
    update();
  }

  FakeWork volume_work, picture_work;
  VisibilitySubject subject;
  WhatMatters::Clock::time_point now = WhatMatters::Clock::now();
  WhatMatters matters{[this](const auto& volume, const auto& stop) -> std::optional<VolumeValues> {
                        if (!volume_work.wait(stop)) return std::nullopt;
                        return measure_values(*volume, {});
                      },
                      [this](const VisibilitySubject& s, const auto& stop) -> std::optional<Visibility> {
                        if (!picture_work.wait(stop)) return std::nullopt;
                        return Visibility{s.scene.volume->statistics.range, {double(s.size.x)}, {0}};
                      }};
};

TEST_F(WhatMattersTest, AVolumeIsMeasuredOnceAndAnotherOneStopsIt) {
  EXPECT_FALSE(matters.is_active());
  volume_work.goes_on = true;
  matters.set_volume(subject.scene.volume);
  EXPECT_TRUE(matters.is_active());
  while (volume_work.begun < 1) std::this_thread::sleep_for(1ms);
  const auto other = std::make_shared<const Volume>(make_builtin("linear?n=5"));
  matters.set_volume(other);
  while (volume_work.begun < 2) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(volume_work.stopped, 1);
  matters.take();
  EXPECT_EQ(matters.values(), nullptr);
  volume_work.goes_on = false;
  settle();
  ASSERT_NE(matters.values(), nullptr);
  EXPECT_EQ(matters.values()->by_value.range, other->statistics.range);
  EXPECT_FALSE(matters.is_active());
  EXPECT_FALSE(matters.has_news(now + 1h));
}

TEST_F(WhatMattersTest, AFailureIsTold) {
  volume_work.fails = picture_work.fails = true;
  matters.set_volume(subject.scene.volume);
  settle();
  EXPECT_EQ(matters.why_no_values(), "no luck");
  update_after_pause();
  settle();
  update();
  EXPECT_EQ(matters.why_no_visibility(), "no luck");
  EXPECT_FALSE(matters.is_active()) << "it is not tried again";
}

TEST_F(WhatMattersTest, VisibilityWaitsForThePictureToRest) {
  update();
  EXPECT_TRUE(matters.is_active());
  EXPECT_FALSE(matters.has_news(now));
  EXPECT_TRUE(matters.has_news(now + WhatMatters::pause));
  now += WhatMatters::pause;
  matters.update(subject, false, now);
  EXPECT_EQ(picture_work.begun, 0) << "a view is being drawn";
  update();
  settle();
  ASSERT_NE(matters.visibility(), nullptr);
  EXPECT_EQ(matters.visibility()->volume, std::vector<double>{8});
  EXPECT_FALSE(matters.is_visibility_old());
  update_after_pause();
  EXPECT_EQ(picture_work.begun, 1) << "it is there already";
}

TEST_F(WhatMattersTest, AChangeDropsTheMeasurement) {
  picture_work.goes_on = true;
  update_after_pause();
  while (picture_work.begun < 1) std::this_thread::sleep_for(1ms);
  subject.scene.tf.points.front().opacity = 0.25;
  update();
  while (picture_work.stopped < 1) std::this_thread::sleep_for(1ms);
  picture_work.goes_on = false;
  now += WhatMatters::pause;
  update();
  settle();
  EXPECT_EQ(picture_work.begun, 2);
  EXPECT_NE(matters.visibility(), nullptr);
  EXPECT_FALSE(matters.is_visibility_old());

  subject.scene.rendering.step = 0.125;  // has no part in the exact picture
  update();
  EXPECT_FALSE(matters.is_visibility_old());
  subject.camera.eye.x += 1;
  update();
  EXPECT_TRUE(matters.is_visibility_old());
  EXPECT_NE(matters.visibility(), nullptr) << "the old one stays until there is another";
  matters.update({}, true, now);
  EXPECT_FALSE(matters.is_active()) << "nobody looks";
}

TEST_F(WhatMattersTest, WhatHasNoExactPictureSaysSo) {
  subject.scene.rendering.blend_mode = BlendMode::maximum;
  update_after_pause();
  EXPECT_NE(matters.why_no_visibility().find("no exact answer"), std::string::npos);
  EXPECT_FALSE(matters.is_active());
  EXPECT_EQ(picture_work.begun, 0);
  subject.scene.rendering.blend_mode = BlendMode::semi_transparent;
  update();
  EXPECT_EQ(matters.why_no_visibility(), "");
}

TEST(VisibilitySize, HasTheViewsShape) {
  EXPECT_EQ(visibility_size({800, 400}), glm::ivec2(80, 40));
  EXPECT_EQ(visibility_size({3, 3000}), glm::ivec2(1, 80));
}

}  // namespace
}  // namespace crest
