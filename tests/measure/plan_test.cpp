#include "render/measure/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "measurements.h"

namespace crest {
namespace {

using testing::measurement;

const std::vector<const Method*> two_methods{find_method("dvr"), find_method("dvr-eye")};

/// A method of this order, whose time goes with the number of samples.
Measurement of_order(double order, std::string method, double step, double speed = 1) {
  return measurement(std::move(method), step, speed / step, std::pow(0.1 * step, order));
}

TEST(Plan, BeginsWithEveryMethodFromCoarseToFine) {
  const auto plan = plan_points(two_methods, {}, default_target());
  ASSERT_EQ(plan.size(), 2 * sweep_steps().size());
  const double steps[] = {4, 4, 1, 1, 0.25, 0.25};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(plan[i].why, Why::coverage);
    EXPECT_EQ(plan[i].step, steps[i]);
    EXPECT_EQ(plan[i].method, two_methods[i % 2]);
    EXPECT_FALSE(plan[i].expected_ms);
  }
  std::set<std::pair<const Method*, double>> distinct;
  for (const PlannedPoint& p : plan) distinct.insert({p.method, p.step});
  EXPECT_EQ(distinct.size(), plan.size());
}

TEST(Plan, AMethodWithoutAStepHasOnePoint) {
  const Method fixed{"fixed", "Fixed", "mode=DVR_ONLY", "", false};
  const auto plan = plan_points(std::vector{&fixed}, {}, default_target());
  ASSERT_EQ(plan.size(), 1u);
  EXPECT_EQ(plan[0].why, Why::coverage);
}

TEST(Plan, BisectsBetweenWhatMissesAndWhatMeetsTheTarget) {
  // Of second order with (0.1 s)^2: rmse 1e-3 is met from s = 0.316 on.
  std::vector<Measurement> measured;
  for (const double step : {4.0, 1.0, 0.25}) measured.push_back(of_order(2, "dvr", step));
  const std::vector<const Method*> dvr{two_methods[0]};
  auto plan = plan_points(dvr, measured, parse_target("rmse=1e-3"));
  EXPECT_EQ(plan[0].why, Why::target);
  EXPECT_EQ(plan[0].step, 0.5);
  EXPECT_NE(plan[1].why, Why::target);
  measured.push_back(of_order(2, "dvr", 0.5));
  for (const auto& p : plan_points(dvr, measured, parse_target("rmse=1e-3"))) EXPECT_NE(p.why, Why::target);
}

TEST(Plan, GoesFinerWhileTheTargetIsMissedButNotInVain) {
  std::vector<Measurement> measured;
  for (const double step : {4.0, 1.0, 0.25}) measured.push_back(of_order(2, "dvr", step));
  const std::vector<const Method*> dvr{two_methods[0]};
  const auto near = plan_points(dvr, measured, parse_target("rmse=1e-5"));
  EXPECT_EQ(near[0].why, Why::target);
  EXPECT_EQ(near[0].step, 1.0 / 16);
  // At 1/64 the error would be 2.4e-6
  EXPECT_NE(plan_points(dvr, measured, parse_target("rmse=1e-7"))[0].why, Why::target);
}

TEST(Plan, TheNeighboursOfTheFrontGoBeforeWhatIsSurelyBeaten) {
  std::vector<Measurement> measured;
  for (const double step : {4.0, 1.0, 0.5, 0.25}) {
    measured.push_back(of_order(2, "dvr", step));
    measured.push_back(of_order(1, "dvr-eye", step, 3));  // slower, and further off
  }
  const auto plan = plan_points(two_methods, measured, parse_target("rmse=1e-3"));
  std::map<std::pair<std::string_view, double>, Why> why;
  for (const PlannedPoint& p : plan) why[{p.method->id, p.step}] = p.why;
  EXPECT_EQ((why[{"dvr", 2.0}]), Why::front);
  EXPECT_EQ((why[{"dvr", 0.125}]), Why::front);
  EXPECT_EQ((why[{"dvr", 1.0 / 32}]), Why::rest);
  EXPECT_EQ((why[{"dvr-eye", 0.125}]), Why::dominated);
  EXPECT_EQ(plan.back().why, Why::dominated);
}

TEST(Plan, ForetellsTimeAndError) {
  const std::vector<Measurement> measured{of_order(2, "dvr", 1), of_order(2, "dvr", 0.5)};
  EXPECT_DOUBLE_EQ(*expected_frame_ms("dvr", 0.125, measured), 8);
  EXPECT_DOUBLE_EQ(*expected_frame_ms("dvr", 4, measured), 1);  // at most
  EXPECT_DOUBLE_EQ(*expected_frame_ms("both", 0.25, measured), 4);
  EXPECT_FALSE(expected_frame_ms("dvr", 1, {}));
  const ErrorMeasure& rmse = *parse_target("rmse=1").measure;
  EXPECT_NEAR(*expected_error("dvr", 0.25, Answer::integral, rmse, measured), 0.025 * 0.025, 1e-12);
  EXPECT_FALSE(expected_error("dvr", 0.25, Answer::crossings, rmse, measured));
  EXPECT_FALSE(expected_error("both", 0.25, Answer::integral, rmse, measured));
}

}  // namespace
}  // namespace crest
