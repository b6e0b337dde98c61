#include "render/measure/pareto.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "measurements.h"

namespace crest {
namespace {

using testing::measurement;
using Indices = std::vector<std::size_t>;

TEST(Pareto, KeepsWhatNoOtherBeats) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<WorkPrecision> points{{1, 9}, {2, 9}, {2, 5}, {3, 7},   {4, 5},
                                          {8, 1}, {9, 1}, {1, 9}, {0, nan}, {nan, 0}};
  EXPECT_EQ(pareto_front(points), (Indices{0, 2, 5}));
  EXPECT_TRUE(pareto_front(std::vector<WorkPrecision>{}).empty());
}

TEST(Pareto, HoldsOnRandomPoints) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coordinate(0, 40);
  for (int round = 0; round < 50; ++round) {
    std::vector<WorkPrecision> points(60);
    for (auto& p : points) p = {double(coordinate(random)), double(coordinate(random))};
    const Indices front = pareto_front(points);
    const auto beats = [](const WorkPrecision& a, const WorkPrecision& b) {
      return a.ms <= b.ms && a.error <= b.error && (a.ms < b.ms || a.error < b.error);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool is_beaten = false, is_there = false;
      for (const auto& other : points) is_beaten = is_beaten || beats(other, points[i]);
      for (const std::size_t f : front)
        is_there = is_there || (points[f].ms == points[i].ms && points[f].error == points[i].error);
      EXPECT_NE(is_beaten, is_there);
    }
    for (std::size_t i = 1; i < front.size(); ++i) {
      EXPECT_LT(points[front[i - 1]].ms, points[front[i]].ms);
      EXPECT_GT(points[front[i - 1]].error, points[front[i]].error);
    }
  }
}

TEST(Recommendation, IsTheFastestUnderTheTarget) {
  const std::vector<Measurement> measured{
      measurement("dvr", 1, 2, 0.1), measurement("dvr", 0.5, 4, 0.01), measurement("dvr", 0.25, 8, 0.001),
      measurement("dvr-eye", 0.5, 3, 0.01), measurement("peaks", 1, 1, 0.0001, Answer::crossings)};
  const auto cheapest = [&](const char* target) {
    return cheapest_under(measured, Answer::integral, parse_target(target));
  };
  EXPECT_EQ(cheapest("rmse=0.01"), 3u);
  EXPECT_EQ(cheapest("rmse=0.005"), 2u);
  EXPECT_EQ(cheapest("rmse=1"), 0u);
  EXPECT_EQ(cheapest("rmse=1e-4"), std::nullopt);
  EXPECT_EQ(cheapest_under(measured, Answer::crossings, parse_target("rmse=1")), 4u);
  EXPECT_EQ(cheapest_under(measured, Answer::base_and_crossings, parse_target("rmse=1")), std::nullopt);
}

}  // namespace
}  // namespace crest
