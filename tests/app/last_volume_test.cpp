#include "app/last_volume.h"

#include <gtest/gtest.h>

#include "render/volume/builtin.h"
#include "tests/classify/tf_of.h"
#include "ui/edit_points.h"

namespace crest {
namespace {

class LastVolumeTest : public ::testing::Test {
 protected:
  Volume from = make_builtin("linear?n=33"), to = make_builtin("linear?n=33&a=2&b=1&c=0.5");
  VolumeValues from_values = *measure_values(from, {}), to_values = *measure_values(to, {});
  ValueRange range = to.statistics.range;
  TransferFunction tf = tf_of({{-1, 0}, {0.3, 0.5}});
};

TEST_F(LastVolumeTest, EachWayInDataValues) {
  const LastVolume last = last_volume(from, "from.nrrd", tf, &from_values);
  EXPECT_EQ(last.name, "linear");
  const auto value = [&](CarryBy by, const VolumeValues* values) {
    return last.carried_to(range, values, by, Domain::data).points[1].value;
  };
  EXPECT_NEAR(value(CarryBy::histogram, &to_values), 0.6, 1e-3);
  EXPECT_NEAR(value(CarryBy::range, &to_values), 0.6, 1e-9);
  EXPECT_NEAR(value(CarryBy::range, nullptr), 0.6, 1e-9);
  EXPECT_EQ(value(CarryBy::value, &to_values), 0.3);
}

TEST_F(LastVolumeTest, ANormalizedOneStaysSo) {
  const TransferFunction normalized = in_domain(tf, Domain::normalized, from.statistics.range);
  const LastVolume last = last_volume(from, "from.nrrd", normalized, &from_values);
  EXPECT_NEAR(last.tf.points[1].value, 0.3, 1e-9);
  const TransferFunction same = last.carried_to(range, &to_values, CarryBy::range, Domain::normalized);
  EXPECT_EQ(same.domain, Domain::normalized);
  EXPECT_NEAR(same.points[1].value, normalized.points[1].value, 1e-9);
  const TransferFunction kept = last.carried_to(range, &to_values, CarryBy::value, Domain::normalized);
  EXPECT_NEAR(in_domain(kept, Domain::data, range).points[1].value, 0.3, 1e-9);
}

}  // namespace
}  // namespace crest
