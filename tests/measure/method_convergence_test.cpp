#include "render/measure/method_convergence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measurements.h"
#include "render/measure/plan.h"

namespace crest {
namespace {

using testing::measurement;

/// An error by step, on the whole ladder.
template <class Error>
std::vector<Measurement> ladder(const Error& error) {
  std::vector<Measurement> measured;
  for (const double step : sweep_steps()) measured.push_back(measurement("dvr", step, 1 / step, error(step)));
  return measured;
}

std::optional<OrderFit> fit(const std::vector<Measurement>& measured) {
  return convergence_of(measured, default_target()).front().fit;
}

TEST(MethodConvergence, APowerOfTheStepIsFittedOverTheWholeLadder) {
  for (const double order : {0.5, 1.0, 2.0}) {
    const auto found = fit(ladder([&](double step) { return 0.01 * std::pow(step, order); }));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->order, order, 1e-9);
    EXPECT_EQ(found->coarsest, 4);
    EXPECT_EQ(found->finest, 1.0 / 64);
    EXPECT_EQ(found->points, 9);
  }
}

TEST(MethodConvergence, NeitherWhereTheStepIsTooCoarseNorWhereRoundingIsLeft) {
  // Flat as long as a spike is lost, then of second order, until rounding
  const auto found =
      fit(ladder([](double step) { return step > 0.6 ? 0.3 : std::max(1e-3 * step * step, 9e-7); }));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->order, 2, 0.05);
  EXPECT_EQ(found->coarsest, 0.5);
  EXPECT_EQ(found->finest, 1.0 / 32);
}

TEST(MethodConvergence, AnErrorThatJumpsHasNoOrder) {
  const double jumps[] = {0.3, 0.29, 0.1, 0.05, 0.049, 0.01, 2e-8, 2e-8, 2e-8};
  std::size_t i = 0;
  EXPECT_FALSE(fit(ladder([&](double) { return jumps[i++]; })));
}

TEST(MethodConvergence, NeedsThreeSteps) {
  EXPECT_FALSE(fit({measurement("dvr", 1, 1, 0.1), measurement("dvr", 0.5, 1, 0.05)}));
  EXPECT_TRUE(fit({measurement("dvr", 1, 1, 0.1), measurement("dvr", 0.5, 1, 0.05),
                   measurement("dvr", 0.125, 1, 0.0125)}));
}

TEST(MethodConvergence, TellsTheCheapestPointUnderTheTarget) {
  const auto measured = ladder([](double step) { return 0.01 * step * step; });
  const auto at = [&](const char* target) {
    return convergence_of(measured, parse_target(target)).front().cheapest;
  };
  ASSERT_TRUE(at("rmse=1e-3"));
  EXPECT_EQ(measured[*at("rmse=1e-3")].step, 0.25);
  EXPECT_FALSE(at("rmse=1e-7"));
  EXPECT_TRUE(convergence_of(measured, parse_target("rmse=1e-3")).front().steady);
}

TEST(MethodConvergence, SaysWhereFinerStepsMissTheTargetAgain) {
  const auto measured = ladder([](double step) { return step == 1 ? 1e-4 : 0.01 * step * step; });
  const auto lucky = convergence_of(measured, parse_target("rmse=1e-3")).front();
  ASSERT_TRUE(lucky.cheapest);
  EXPECT_EQ(measured[*lucky.cheapest].step, 1);
  EXPECT_FALSE(lucky.steady);
}

}  // namespace
}  // namespace crest
