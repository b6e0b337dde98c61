#include "render/measure/choose_setting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pictures.h"
#include "presets/choices.h"
#include "presets/error.h"
#include "render/measure/plan.h"
#include "scenes.h"

namespace crest {
namespace {

constexpr glm::ivec2 full{512, 512};

/// A renderer on a clock of its own, in which `share` of the pixels are off, spread over the picture, and a
/// full frame takes `ms`. Both know a setting by its rendering.
struct FakeProbe {
  std::function<double(const Rendering&)> share = [](const Rendering& r) {
    return is_analytic(r.classification) ? 0 : 0.0044 * r.step * r.step;
  };
  std::function<double(const Rendering&)> ms = [](const Rendering& r) {
    return is_analytic(r.classification) ? 400 : 50 / r.step;
  };
  double exact_us = 10;        ///< of a ray
  double sparse_bias = 1;      ///< of times in sparse pictures
  double compile_seconds = 0;  ///< of each picture
  double now = 0;
  int exact_pictures = 0;
  std::vector<std::size_t> timed;  ///< how many at once
  std::stop_source stop;
  int stop_after = 1 << 30;  ///< pictures

  static bool is_wrong(std::size_t pixel, double share) {
    return double((pixel * 2654435761u) % 1000003) < share * 1000003;
  }
  static double part(glm::ivec2 size) { return double(size.x * size.y) / (full.x * full.y); }

  SceneProbe probe() {
    SceneProbe p;
    p.seconds = [this] { return now; };
    p.exact = [this](const ExactAnswer&, glm::ivec2 size, const Progress& progress) {
      ++exact_pictures;
      now += 1e-6 * exact_us * size.x * size.y;
      if (!progress(1)) throw Cancelled{};
      return testing::as_exact(testing::filled(size, glm::vec4(0.5f)));
    };
    p.picture = [this](const Rendering& r, glm::ivec2 size, bool) {
      now += compile_seconds + 1e-3 * ms(r) * part(size);
      if (--stop_after == 0) stop.request_stop();
      Image image = testing::filled(size, glm::vec4(0.5f));
      for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (is_wrong(i, share(r))) image.pixels[i].r += 0.1f;
      return SceneProbe::Picture{image, {}};
    };
    p.sparse_ms = [this](const Rendering& r, glm::ivec2 size) { return sparse_bias * ms(r) * part(size); };
    p.frame_ms = [this](std::span<const Rendering> renderings) {
      timed.push_back(renderings.size());
      std::vector<double> times;
      for (const Rendering& r : renderings) times.push_back(ms(r));
      return times;
    };
    return p;
  }
};

Scene scene_in(Mode mode) {
  Scene scene = testing::scene_with_peak(0.5);
  scene.rendering.mode = mode;
  return scene;
}

Choice choose(FakeProbe& fake, const Scene& scene, const ChoiceSettings& settings = {}) {
  return choose_setting(scene, full, fake.probe(), settings, fake.stop.get_token()).value();
}

TEST(ChooseSetting, TakesTheCoarsestStepThatIsSurelyWithinTheTarget) {
  FakeProbe fake;  // 0.0044 s^2: 0.0011 at 0.5
  const Choice choice = choose(fake, scene_in(Mode::dvr_only));
  EXPECT_EQ(choice.setting.step, 0.25);
  EXPECT_NE(choice.setting.method->id, "dvr-analytic");
  EXPECT_TRUE(choice.meets_target);
  EXPECT_TRUE(choice.setting.is_timed);
  EXPECT_EQ(choice.setting.frame_ms, 200);
  EXPECT_LE(choice.setting.error.high, 0.001);
  EXPECT_EQ(choice.rendering.mode, Mode::dvr_only);
  EXPECT_EQ(choice.rendering.step, 0.25);
}

TEST(ChooseSetting, TheExactMarchWhereSamplingIsSlowerOrNotSure) {
  FakeProbe slow;
  slow.ms = [](const Rendering& r) { return is_analytic(r.classification) ? 150 : 50 / r.step; };
  EXPECT_EQ(choose(slow, scene_in(Mode::dvr_only)).setting.method->id, "dvr-analytic");

  FakeProbe wrong;  // at every step
  wrong.share = [](const Rendering& r) { return is_analytic(r.classification) ? 0 : 0.0011; };
  wrong.ms = [](const Rendering& r) { return is_analytic(r.classification) ? 4000 : 5 / r.step; };
  const Choice choice = choose(wrong, scene_in(Mode::peak_xor_dvr));
  EXPECT_EQ(choice.setting.method->id, "xor-analytic");
  EXPECT_TRUE(choice.meets_target);
  for (const TriedSetting& tried : choice.tried)
    if (tried.method->has_step) {
      EXPECT_NE(tried.verdict, Verdict::met);
    }
}

TEST(ChooseSetting, RaysAreAddedWhereItIsUnclear) {
  FakeProbe fake;
  fake.share = [](const Rendering& r) { return is_analytic(r.classification) ? 0 : 0.00055 * r.step; };
  const Choice choice = choose(fake, scene_in(Mode::dvr_only));
  EXPECT_EQ(choice.setting.step, 1);  // 0.00055: of 4500 rays two or so are wrong
  EXPECT_GT(choice.setting.error.rays, 10000u);

  FakeProbe hurried = fake;
  hurried.exact_us = 500;  // an exact answer of more rays takes longer than the probe may
  const Choice without = choose(hurried, scene_in(Mode::dvr_only));
  EXPECT_LT(without.setting.step, 1);
  EXPECT_TRUE(without.meets_target);
}

TEST(ChooseSetting, CandidatesHaveTheScenesModeAndField) {
  FakeProbe fake;
  Scene scene = scene_in(Mode::peak_xor_dvr);
  scene.rendering.peak_form = PeakForm::paper;
  for (const auto& tried : choose(fake, scene).tried)
    EXPECT_TRUE(tried.method->id.starts_with("xor")) << tried.method->id;

  scene = scene_in(Mode::dvr_only);
  scene.rendering.filter = Filter::bspline;
  const Choice cubic = choose(fake, scene);
  EXPECT_EQ(cubic.rendering.filter, Filter::bspline);
  for (const auto& tried : cubic.tried) {
    EXPECT_EQ(measured_rendering(*tried.method, 1, scene.rendering).filter, Filter::bspline);
    EXPECT_TRUE(tried.method->has_step);
  }
}

TEST(ChooseSetting, WhatMethodsDoNotTouchStays) {
  FakeProbe fake;
  Scene scene = scene_in(Mode::both);
  scene.rendering.shading = Shading::gradient;
  scene.rendering.early_termination = 0.02;
  scene.rendering.background = {1, 1, 1};
  scene.rendering.adaptive = true;
  const Choice choice = choose(fake, scene);
  EXPECT_EQ(choice.rendering.shading, Shading::gradient);
  EXPECT_EQ(choice.rendering.early_termination, 0.02);
  EXPECT_EQ(choice.rendering.background, scene.rendering.background);
  EXPECT_EQ(choice.rendering, with_method(scene.rendering, *choice.setting.method, choice.setting.step));
}

TEST(ChooseSetting, TheTimesOfTheFullPictureDecide) {
  FakeProbe fake;
  fake.share = [](const Rendering&) { return 0.0; };
  fake.ms = [](const Rendering& r) {
    return r.classification == ClassificationMethod::preintegrated ? 90.0
           : is_analytic(r.classification)                         ? 100.0
                                                                   : 300.0;
  };
  Scene scene = scene_in(Mode::peak_xor_dvr);
  const auto probe = fake.probe();
  SceneProbe biased = probe;
  biased.sparse_ms = [&](const Rendering& r, glm::ivec2 size) {
    return probe.sparse_ms(r, size) * (r.classification == ClassificationMethod::preintegrated ? 1.4 : 1);
  };
  const Choice choice = choose_setting(scene, full, biased).value();
  EXPECT_EQ(choice.setting.method->id, "xor-pre");
  EXPECT_EQ(choice.setting.frame_ms, 90);
  EXPECT_GT(fake.timed.back(), 1u);
}

TEST(ChooseSetting, WithinABudgetTheLeastError) {
  FakeProbe fake;
  ChoiceSettings settings;
  settings.budget_ms = 130;
  const Choice choice = choose(fake, scene_in(Mode::dvr_only), settings);
  EXPECT_EQ(choice.setting.step, 0.5);  // 100 ms; 0.25 takes 200
  EXPECT_TRUE(choice.fits_budget);
  EXPECT_LE(choice.setting.frame_ms, 130);

  settings.budget_ms = 1000;
  EXPECT_EQ(choose(fake, scene_in(Mode::dvr_only), settings).setting.method->id, "dvr-analytic");
}

TEST(ChooseSetting, SaysPlainlyWhatCannotBeKept) {
  FakeProbe fake;
  ChoiceSettings settings;
  settings.budget_ms = 30;
  const Choice coarse = choose(fake, scene_in(Mode::dvr_only), settings);
  EXPECT_TRUE(coarse.fits_budget);
  EXPECT_FALSE(coarse.meets_target);
  EXPECT_NE(coarse.why.find("no setting tried surely keeps share=0.001 in 30 ms"), std::string::npos)
      << coarse.why;

  settings.budget_ms = 1;
  const Choice none = choose(fake, scene_in(Mode::dvr_only), settings);
  EXPECT_FALSE(none.fits_budget);
  EXPECT_NE(none.why.find("no setting tried draws a frame in 1 ms"), std::string::npos) << none.why;
  EXPECT_EQ(none.setting.step, 4);  // the fastest

  Scene cubic = scene_in(Mode::dvr_only);
  cubic.rendering.filter = Filter::bspline;
  fake.share = [](const Rendering& r) { return 0.1 + 0.1 * r.step; };
  const Choice closest = choose(fake, cubic);
  EXPECT_FALSE(closest.meets_target);
  EXPECT_NE(closest.why.find("no setting tried surely keeps"), std::string::npos) << closest.why;
  for (const auto& tried : closest.tried) EXPECT_GE(tried.error.value, closest.setting.error.value);
}

TEST(ChooseSetting, TheFirstMethodsAreTriedHoweverLongItTakes) {
  FakeProbe fake;
  fake.compile_seconds = 10;
  const Choice choice = choose(fake, scene_in(Mode::dvr_only));
  std::set<std::string_view> tried;
  for (const auto& t : choice.tried) tried.insert(t.method->id);
  EXPECT_EQ(tried, (std::set<std::string_view>{"dvr-analytic", "dvr", "dvr-pre", "dvr-pre-table"}));
  EXPECT_FALSE(choice.untried.empty());
  EXPECT_TRUE(choice.meets_target);
}

TEST(ChooseSetting, NoSettingIsTriedTwice) {
  FakeProbe fake;
  for (const auto budget : {std::optional<double>(), std::optional<double>(60)}) {
    ChoiceSettings settings;
    settings.budget_ms = budget;
    std::set<std::pair<std::string_view, double>> seen;
    for (const auto& t : choose(fake, scene_in(Mode::dvr_only), settings).tried)
      EXPECT_TRUE(seen.insert({t.method->id, t.step}).second) << t.method->id << " " << t.step;
  }
}

TEST(ChooseSetting, CanBeStopped) {
  FakeProbe fake;
  fake.stop_after = 2;
  EXPECT_FALSE(choose_setting(scene_in(Mode::dvr_only), full, fake.probe(), {}, fake.stop.get_token()));
}

TEST(ChooseSetting, WithoutAMethodItSaysWhy) {
  FakeProbe fake;
  Scene scene = scene_in(Mode::dvr_only);
  for (auto& point : scene.tf.points) point.opacity = 0;
  try {
    choose(fake, scene);
    FAIL() << "there is nothing to choose from";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no point of the transfer function has an opacity"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace crest
