#include "render/studies/knoll/sampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crest::testing {
namespace {

TEST(LongestStepWithin, FindsWhereTheErrorIsTheTarget) {
  for (const double wanted : {0.06, 0.4, 1.0, 1.7, 6.5}) {
    int asked = 0;
    const auto step = longest_step_within(
        wanted * wanted, [&](double s) { return ++asked, s * s; }, 1.0 / 32, 8);
    ASSERT_TRUE(step) << wanted;
    EXPECT_LE(*step, wanted) << wanted;
    EXPECT_GT(*step, wanted / 1.03) << wanted;
    EXPECT_LE(asked, 14) << wanted;
  }
}

TEST(LongestStepWithin, IsTheLongestWhereAllDo) {
  EXPECT_EQ(longest_step_within(
                1, [](double) { return 0.5; }, 1.0 / 32, 8),
            8);
}

TEST(LongestStepWithin, IsNothingWhereNoneDoes) {
  double shortest_asked = 1;
  const auto error = [&](double s) {
    shortest_asked = std::min(shortest_asked, s);
    return 2.0;
  };
  EXPECT_FALSE(longest_step_within(1, error, 1.0 / 20, 8));
  EXPECT_EQ(shortest_asked, 1.0 / 20) << "the shortest itself is tried";
}

TEST(LongestStepWithin, TheShortestMayDo) {
  const auto step = longest_step_within(
      1, [](double s) { return s <= 0.05 ? 1.0 : 2.0; }, 0.05, 8);
  ASSERT_TRUE(step);
  EXPECT_EQ(*step, 0.05);
}

// A frame takes some time for its samples, and some that no step changes.
TEST(StepOfEqualCost, FindsIt) {
  const auto ms = [](double step) { return 3 + 40 / step; };
  for (const double wanted : {0.3, 1.0, 2.5}) {
    const auto ratio = [&](double step) { return ms(step) / ms(wanted); };
    EXPECT_NEAR(ratio(step_of_equal_cost(1, ratio, 0.03, 5, 1.0 / 32, 8)), 1, 0.03) << wanted;
  }
}

TEST(StepOfEqualCost, IsTheBestOfItsTurns) {
  int turn = 0;
  const auto noisy = [&](double) { return std::vector{2.0, 1.1, 1.5, 0.6}[std::size_t(turn++)]; };
  EXPECT_EQ(step_of_equal_cost(1, noisy, 0.01, 4, 1.0 / 32, 8), 2);
  EXPECT_EQ(turn, 4);
}

}  // namespace
}  // namespace crest::testing
