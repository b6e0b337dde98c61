#include "render/measure/sweep.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "pictures.h"
#include "presets/error.h"
#include "scenes.h"

namespace crest {
namespace {

/// A renderer of second order on a clock of its own: a frame takes `ms_at_1` / step, an exact answer
/// `reference_seconds`. The machine gets slower by a thousandth with each frame.
struct FakeRenderer {
  double ms_at_1 = 10, reference_seconds = 1, drift = 1e-3;
  double now = 0;
  int frames = 0, starts = 0;
  std::vector<ExactAnswer> references;
  std::vector<double> frame_steps;

  static double step_of(const Rendering& r) {
    return r.sampling == Sampling::uniform ? r.step : r.s_k / 8;  // as methods() have it
  }
  double frame_seconds(const Rendering& r) const {
    return 1e-3 * ms_at_1 / step_of(r) * (1 + drift * frames);
  }

  Measurer measurer() {
    Measurer m;
    m.seconds = [this] { return now; };
    m.reference = [this](const ExactAnswer& answer, const Progress& progress) {
      references.push_back(answer);
      for (int part = 1; part <= 100; ++part) {
        now += 0.01 * reference_seconds;
        if (!progress(0.01 * part)) throw Cancelled{};
      }
      Reference exact = testing::as_exact(testing::filled({4, 4}, glm::vec4(0.5f)));
      exact.crossings.assign(16, 1);
      return exact;
    };
    m.start = [this](const Rendering& r) {
      ++starts;
      now += 0.1 + frame_seconds(r);
      return Measurer::Start{100 + 1e3 * frame_seconds(r), 7};
    };
    m.picture = [this](const Rendering& r) {
      now += 2 * frame_seconds(r);
      Measurer::Picture picture;
      picture.image = testing::filled({4, 4}, glm::vec4(float(0.5 + 0.01 * step_of(r) * step_of(r))));
      picture.samples_per_ray = 100 / step_of(r);
      picture.crossings.assign(16, 1);
      return picture;
    };
    m.frame = [this](const Rendering& r) {
      ++frames;
      frame_steps.push_back(step_of(r));
      now += frame_seconds(r);
      return Measurer::FrameTime{1e3 * frame_seconds(r), 900 * frame_seconds(r)};
    };
    return m;
  }
};

/// Of all methods, in a scene with the default filters.
std::set<ExactAnswer> all_answers() {
  std::set<ExactAnswer> answers;
  for (const Method& method : methods())
    for (const ExactAnswer& exact : exact_answers_of(method)) answers.insert(exact);
  return answers;
}

bool is_trilinear(const ExactAnswer& exact) { return exact.filters == AnswerFilters{}; }
bool has_trilinear_answers(const Method& method) { return is_trilinear(exact_answers_of(method)[0]); }

std::size_t count_of_trilinear_dvr_methods() {
  return std::size_t(std::ranges::count_if(methods(), [](const Method& m) {
    return m.id.starts_with("dvr") && m.has_step && has_trilinear_answers(m);
  }));
}

std::vector<double> steps_of(const Method& method) {
  return method.has_step ? std::vector<double>(sweep_steps().begin(), sweep_steps().end()) : std::vector{0.0};
}

std::size_t count_of_points() {
  std::size_t count = 0;
  for (const Method& method : methods()) count += steps_of(method).size();
  return count;
}

std::vector<Measurement> run(Sweep& sweep) {
  std::vector<Measurement> points;
  while (auto point = sweep.next()) {
    EXPECT_EQ(point->image.size, glm::ivec2(4));
    points.push_back(point->measurement);
  }
  return points;
}

TEST(Sweep, WithoutABudgetMeasuresEveryPointOnce) {
  FakeRenderer renderer;
  Sweep sweep(testing::scene_with_peak(0.5), renderer.measurer());
  const auto points = run(sweep);
  EXPECT_EQ(points.size(), count_of_points());
  std::set<std::pair<std::string, double>> distinct;
  for (const Measurement& m : points) {
    distinct.insert({m.method, m.step});
    EXPECT_EQ(m.errors.size(), exact_answers_of(*find_method(m.method)).size());
    const double step = m.step > 0 ? m.step : Rendering{}.step;  // of what the fake one draws
    EXPECT_NEAR(m.errors[0].error.compared.rmse, 0.01 * step * step, 1e-7);
    EXPECT_DOUBLE_EQ(m.samples_per_ray, 100 / step);
    EXPECT_NEAR(m.device_ms, 0.9 * m.frame_ms, 1e-9);
    EXPECT_GE(m.frame_ms_all.size(), 3u);
    const bool is_dvr = m.method.starts_with("dvr");
    EXPECT_EQ(m.errors[0].error.crossings.has_value(), !is_dvr);
  }
  EXPECT_EQ(distinct.size(), points.size());
  EXPECT_EQ(sweep.measured().size(), points.size());
  EXPECT_TRUE(sweep.left_out().empty());
  EXPECT_EQ(sweep.references().size(), all_answers().size());
}

TEST(Sweep, BeginsWithTheScenesOwnModeThenIntegral) {
  FakeRenderer renderer;
  Scene scene = testing::scene_with_peak(0.5);
  scene.rendering.mode = Mode::peak_only;
  Sweep sweep(scene, renderer.measurer());
  const auto first = sweep.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->measurement.method, "peaks");
  EXPECT_EQ(first->measurement.step, 4);
  EXPECT_EQ(renderer.references, std::vector{ExactAnswer(Answer::crossings)});  // the others come later
  run(sweep);
  ASSERT_EQ(renderer.references.size(), all_answers().size());
  EXPECT_EQ(renderer.references[1], Answer::integral);
  EXPECT_EQ(std::ranges::count_if(renderer.references, is_trilinear), 4);
  EXPECT_TRUE(std::ranges::is_partitioned(renderer.references, is_trilinear)) << "other filters come last";
}

TEST(Sweep, ComesToOtherFiltersWhenLittleIsLeftToLearn) {
  FakeRenderer renderer;
  Sweep sweep(testing::scene_with_peak(0.5), renderer.measurer());
  const auto points = run(sweep);
  const auto is_trilinear_point = [](const Measurement& m) { return is_trilinear(m.errors[0].answer); };
  const auto first_other = std::ranges::find_if_not(points, is_trilinear_point);
  ASSERT_NE(first_other, points.end());
  for (auto m = first_other; m != points.end(); ++m)
    if (is_trilinear_point(*m)) {
      EXPECT_GE(m->why, Why::front) << m->method << m->step;
    }
}

TEST(Sweep, TimesAGroupTurnByTurnWithTheAnchor) {
  FakeRenderer renderer;
  renderer.drift = 0.05;  // so that what was timed later is slower
  Scene scene = testing::scene_with_peak(0.5);
  scene.rendering.mode = Mode::dvr_only;
  Sweep sweep(scene, renderer.measurer(), {.frames = 5});
  std::map<int, std::vector<Measurement>> groups;
  for (const Measurement& m : run(sweep)) groups[m.group].push_back(m);
  EXPECT_EQ(groups[0].size(), 1u);                                    // nothing is known of the time before
  ASSERT_EQ(groups[1].size(), count_of_trilinear_dvr_methods() - 1);  // the others at the same step
  for (const Measurement& m : groups[1]) EXPECT_EQ(m.step, 4);
  // Timed one after the other, with 5 frames each, the last would be half as slow again as the first.
  EXPECT_LT(groups[1].back().frame_ms / groups[1][0].frame_ms, 1.15);
  // All that differs between groups is the machine, and the anchor tells by how much.
  EXPECT_GT(groups[1][0].frame_ms_all[0] / groups[0][0].frame_ms_all[0], 1.2);
  EXPECT_GT(groups[1][0].anchor_ms / groups[0][0].anchor_ms, 1.2);
  EXPECT_NEAR(groups[1][0].frame_ms / groups[0][0].frame_ms, 1, 0.1);  // so it is taken out
}

TEST(Sweep, KeepsToItsBudgetAndSaysWhatItLeftOut) {
  for (const double seconds_a_method : {3.0, 5.0}) {
    const double budget = seconds_a_method * double(methods().size());
    FakeRenderer renderer;
    renderer.ms_at_1 = 40;  // a point at 1/64 takes 13 s
    Sweep sweep(testing::scene_with_peak(0.5), renderer.measurer(), {.budget_seconds = budget});
    const auto points = run(sweep);
    EXPECT_LT(renderer.now, 1.2 * budget);
    EXPECT_GT(renderer.now, 0.8 * budget);
    // The scene's own field is covered, and nothing is left out in silence
    const auto is_measured = [&](const Method& method, double step) {
      return std::ranges::any_of(points, [&](auto& m) { return m.method == method.id && m.step == step; });
    };
    const auto is_told = [&](std::string_view what) {
      return std::ranges::any_of(sweep.left_out(), [&](const LeftOut& left) { return left.what == what; });
    };
    for (const Method& method : methods()) {
      if (has_trilinear_answers(method)) {
        EXPECT_TRUE(is_measured(method, method.has_step ? 0.25 : 0)) << method.id;
      }
      for (const double step : steps_of(method))
        EXPECT_NE(is_measured(method, step),
                  is_told(method.id) || is_told(fmt::format("{} at step {}", method.id, step)))
            << method.id << " at " << step;
    }
  }
}

TEST(Sweep, GivesUpAnExactAnswerThatWouldTakeMostOfTheBudget) {
  FakeRenderer renderer;
  renderer.reference_seconds = 100;
  Sweep sweep(testing::scene_with_peak(0.5), renderer.measurer(), {.budget_seconds = 60});
  EXPECT_TRUE(run(sweep).empty());
  EXPECT_LT(renderer.now, 10);  // its time was foretold early
  // All answers, and all methods, which have none
  EXPECT_EQ(sweep.left_out().size(), all_answers().size() + methods().size());
  EXPECT_NE(sweep.left_out()[0].why.find("it would take 100 s"), std::string::npos)
      << sweep.left_out()[0].why;
}

TEST(Sweep, StopsWhenAskedTo) {
  FakeRenderer renderer;
  Sweep sweep(testing::scene_with_peak(0.5), renderer.measurer());
  std::stop_source stop;
  std::size_t points = 0;
  while (auto point = sweep.next(stop.get_token()))
    if (++points == 15) stop.request_stop();
  EXPECT_GE(points, 15u);
  EXPECT_LT(points, 30u);
  // Within an exact answer, too
  FakeRenderer other;
  Sweep second(testing::scene_with_peak(0.5), other.measurer());
  std::stop_source at_once;
  EXPECT_FALSE(second.next(at_once.get_token(), [&](std::string_view doing, double done) {
    EXPECT_EQ(doing, "exact answer 'integral+crossings'");
    if (done > 0.3) at_once.request_stop();
  }));
  EXPECT_LT(other.now, 0.4);
  EXPECT_TRUE(second.references().empty());
}

TEST(Sweep, StartsEachMethodOnce) {
  FakeRenderer renderer;
  Sweep sweep(testing::scene_with_peak(0.5), renderer.measurer(),
              {.budget_seconds = 3 * double(methods().size())});
  run(sweep);
  EXPECT_EQ(renderer.starts, int(methods().size()));
  ASSERT_EQ(sweep.starts().size(), methods().size());
  for (const MethodStart& start : sweep.starts()) {
    EXPECT_EQ(start.step, find_method(start.method)->has_step ? 4 : 0);
    EXPECT_GT(start.first_frame_ms, 100);
    EXPECT_EQ(start.edit_ms, 7);
  }
}

TEST(Sweep, LeavesOutMethodsThatMakeNoSense) {
  FakeRenderer renderer;
  Scene scene = testing::scene_with_peak(3);
  scene.rendering.mode = Mode::dvr_only;
  Sweep sweep(scene, renderer.measurer());
  for (const Measurement& m : run(sweep)) EXPECT_TRUE(m.method.starts_with("dvr")) << m.method;
  for (const ExactAnswer& exact : renderer.references) EXPECT_EQ(exact.answer, Answer::integral);
  EXPECT_EQ(sweep.left_out().size(),
            std::size_t(std::ranges::count_if(methods(), [](auto& m) { return !m.id.starts_with("dvr"); })));
}

}  // namespace
}  // namespace crest
