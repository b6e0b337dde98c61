#include "render/studies/knoll/table_builds.h"

#include <gtest/gtest.h>

#include <array>

#include "presets/preset_file.h"

namespace crest::testing {
namespace {

TEST(TableBuilds, ATimeForEachSize) {
  const TransferFunction tf = resolve(load_preset("onion").transfer_function, {0, 255}, 1);
  const std::array<int, 2> bins{16, 256};
  const auto builds = time_table_builds(tf, {0, 255}, 1, bins);
  ASSERT_EQ(builds.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(builds[i].bins, bins[i]);
    EXPECT_GT(builds[i].peak_ms, 0);
    EXPECT_GT(builds[i].preintegration_ms, 0);
    EXPECT_DOUBLE_EQ(builds[i].ratio() * builds[i].peak_ms, builds[i].preintegration_ms);
  }
  EXPECT_GT(builds[1].preintegration_ms, 10 * builds[0].preintegration_ms) << "256 times the entries";
}

}  // namespace
}  // namespace crest::testing
