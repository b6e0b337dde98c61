#include "presets/exchange/steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/presets/export_inputs.h"
#include "tests/presets/random_tf.h"

namespace crest {
namespace {

TEST(Steps, AreMovedNoFurtherThanTheirGaps) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    const TransferFunction tf = random_tf(random, 300);
    const double size = std::max(std::abs(tf.range().min), std::abs(tf.range().max));
    for (const Separation& separation : {drawn_apart, slicer_apart}) {
      const auto values = separated_values(tf, separation);
      const double gap =
          separation.units * 0x1p-23 * std::max(size, separation.least_size * tf.range().width());
      for (std::size_t i = 1; i < values.size(); ++i) ASSERT_LT(values[i - 1], values[i]);
      // In the worst case all points are in one group
      std::size_t largest_group = 1, group = 1;
      for (std::size_t i = 1; i < values.size(); ++i) {
        group = tf.points[i].value - tf.points[i - 1].value < 2 * gap ? group + 1 : 1;
        largest_group = std::max(largest_group, group);
      }
      EXPECT_LE(farthest_move(tf, values), 1.01 * gap * double(largest_group));
    }
  }
}

// A spike keeps the value of its tip, and points that are apart stay.
TEST(Steps, LeaveWhatIsApart) {
  TransferFunction tf = spike();
  auto values = separated_values(tf, drawn_apart);
  EXPECT_EQ(values[0], 0);
  EXPECT_LT(values[1], 0.5);
  EXPECT_EQ(values[2], 0.5);
  EXPECT_GT(values[3], 0.5);
  EXPECT_EQ(values[4], 1);
  tf.points[1].value = 0.5 - 1e-7;
  tf.points[3].value = 0.5 + 1e-7;
  values = separated_values(tf, drawn_apart);
  EXPECT_EQ(values[1], 0.5 - 1e-7) << "no step";
  values = separated_values(tf, slicer_apart);
  EXPECT_EQ(values[2], 0.5);
  EXPECT_LT(values[1], 0.5 - 5e-7);
}

}  // namespace
}  // namespace crest
