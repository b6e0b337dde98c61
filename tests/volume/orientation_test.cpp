#include "render/volume/orientation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crest {
namespace {

using Axes = std::array<AxisEnds, 3>;

Volume turned(const glm::dmat3& direction) {
  Volume volume;
  volume.direction = direction;
  volume.is_in_patient = true;
  return volume;
}

TEST(Orientation, AxesGoToTheLeftTheBackAndTheHead) {
  EXPECT_EQ(anatomical_axes(turned(glm::dmat3(1))), (Axes{{{'R', 'L'}, {'A', 'P'}, {'I', 'S'}}}));
}

TEST(Orientation, AxesAreNamedByWhatTheyAreNearestTo) {
  const glm::dmat3 sagittal({0, 1, 0}, {0, 0, -1}, {-1, 0, 0});
  EXPECT_EQ(anatomical_axes(turned(sagittal)), (Axes{{{'A', 'P'}, {'S', 'I'}, {'L', 'R'}}}));
  const double c = std::cos(0.5), s = std::sin(0.5);
  const glm::dmat3 oblique({c, s, 0}, {-s, c, 0}, {0, 0, 1});
  EXPECT_EQ(anatomical_axes(turned(oblique)), (Axes{{{'R', 'L'}, {'A', 'P'}, {'I', 'S'}}}));
}

TEST(Orientation, IsNotGuessed) {
  EXPECT_EQ(anatomical_axes(Volume()), std::nullopt);
  EXPECT_EQ(anatomical_axes(turned(glm::dmat3({1, 0, 0}, {0.9, 0.1, 0}, {0, 0, 1}))), std::nullopt);
}

}  // namespace
}  // namespace crest
