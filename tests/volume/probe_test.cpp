#include "render/volume/probe.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/volume/builtin.h"
#include "render/volume/random.h"
#include "tests/raycaster/reconstruct.h"

namespace crest::test {
namespace {

TEST(Probe, IsTheFiltersField) {
  const Volume volume = make_builtin("noise?n=9");
  Random random(5);
  for (const FieldFilter& filter : {FieldFilter{Filter::linear}, FieldFilter{Filter::linear_exact},
                                    FieldFilter{Filter::bspline}, FieldFilter{Filter::bc, 0.2, 0.6}})
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 place{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
      const double expected = crest::testing::reconstruct(volume, filter, place * 8.0);
      EXPECT_NEAR(value_at(volume, filter, place).value(), expected, 1e-12);
    }
}

TEST(Probe, AtPointsAndBeyondTheBox) {
  const Volume volume = make_builtin("linear?n=5");
  EXPECT_EQ(value_at(volume, {}, {0, 0, 0}), -1.75);
  EXPECT_EQ(value_at(volume, {}, {1, 1, 1}), 1.75);
  EXPECT_EQ(value_at(volume, {}, {2, 0.5, -1}), 1 - 0.25);
}

TEST(Probe, ThereIsNoneBesideAPointWithoutOne) {
  Volume volume = make_builtin("linear?n=9");
  volume.values.floats()[0] = NAN;
  EXPECT_FALSE(value_at(volume, {}, {0.1, 0.1, 0.1}));
  EXPECT_TRUE(value_at(volume, {}, {0.15, 0.1, 0.1}));
  EXPECT_FALSE(value_at(volume, {Filter::bspline}, {0.15, 0.1, 0.1}));
}

}  // namespace
}  // namespace crest::test
