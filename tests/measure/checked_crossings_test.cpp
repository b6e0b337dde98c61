#include "render/measure/checked_crossings.h"

#include <gtest/gtest.h>

namespace crest {
namespace {

ExactRay ray_with_surfaces(const std::vector<double>& depths) {
  ExactRay ray{.enter = 0, .exit = 10, .places = {{}}};
  for (const double depth : depths) {
    RayPlace place;
    place.depth = depth;
    place.opacity = ray.places.back().opacity + 0.01;
    place.surface = 0.5;
    ray.places.push_back(place);
  }
  return ray;
}

TEST(CheckedCrossings, TellsWhichStepFoundWhich) {
  const ExactRay ray = ray_with_surfaces({0.5, 1.2, 1.4, 3.5});
  const std::vector<TracedStep> steps{{0, {}, 0}, {1, {}, 1}, {2, {}, 2}, {3, {}, 2}, {4, {}, 3}};
  const CheckedCrossings checked = check_crossings(ray, steps);
  ASSERT_EQ(checked.exact.size(), 4u);
  EXPECT_TRUE(checked.exact[0].found && checked.exact[1].found && checked.exact[3].found);
  EXPECT_FALSE(checked.exact[2].found) << "of two in one step one was found";
  EXPECT_EQ(checked.missed(), 1);
  EXPECT_EQ(checked.invented, 0);
}

TEST(CheckedCrossings, OneThatIsInventedIsCounted) {
  const std::vector<TracedStep> steps{{0, {}, 0}, {1, {}, 1}, {2, {}, 2}};
  const CheckedCrossings checked = check_crossings(ray_with_surfaces({0.5}), steps);
  EXPECT_EQ(checked.missed(), 0);
  EXPECT_EQ(checked.invented, 1);
}

TEST(CheckedCrossings, AtAStepsEndItCountsInEither) {
  const ExactRay ray = ray_with_surfaces({1.0000001});
  const std::vector<TracedStep> steps{{0, {}, 0}, {1, {}, 1}, {2, {}, 1}};
  EXPECT_EQ(check_crossings(ray, steps).missed(), 0);
  EXPECT_EQ(check_crossings(ray, steps).invented, 0);
}

TEST(CheckedCrossings, BehindWhatIsOpaqueNothingIsMissed) {
  ExactRay ray = ray_with_surfaces({0.5, 2.5});
  ray.places[1].opacity = 1;
  const CheckedCrossings checked =
      check_crossings(ray, std::vector<TracedStep>{{0, {}, 0}, {1, {}, 1}, {3, {}, 1}});
  EXPECT_EQ(checked.exact.size(), 1u);
  EXPECT_EQ(checked.missed(), 0);
}

}  // namespace
}  // namespace crest
