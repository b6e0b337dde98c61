#include "ui/table_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace crest {
namespace {

std::vector<Peak> peaks_at(std::vector<double> values) {
  std::ranges::sort(values);
  std::vector<Peak> peaks(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) peaks[i].value = values[i];
  return peaks;
}

/// What is painted in each cell, entry bin fastest: a peak's index, -1 for nothing, -2 for more than one
/// region.
std::vector<int> painted(const std::vector<TableRegion>& regions, int bins) {
  std::vector<int> cells(std::size_t(bins) * std::size_t(bins), -1);
  for (const TableRegion& region : regions)
    for (int exit = region.first_exit; exit <= region.last_exit; ++exit)
      for (int entry = region.first_entry; entry <= region.last_entry; ++entry) {
        int& cell = cells.at(std::size_t(exit) * std::size_t(bins) + std::size_t(entry));
        cell = cell == -1 ? region.peak : -2;
      }
  return cells;
}

std::vector<int> first_met(const PeakTable& table) {
  std::vector<int> cells;
  for (int exit = 0; exit < table.bins; ++exit)
    for (int entry = 0; entry < table.bins; ++entry) cells.push_back(peaks_met(table, entry, exit)[0]);
  return cells;
}

TEST(TableRegions, EachCellShowsThePeakThatIsMetFirst) {
  std::mt19937 random(29);
  for (int trial = 0; trial < 300; ++trial) {
    const int bins = 1 + int(random() % 60);
    // A narrow range far from zero has bins that rounding makes overlap
    const double offset = trial % 3 == 0 ? 1e5 : 0;
    std::vector<double> values(random() % 20);
    for (double& value : values) value = offset + double(random() % 1300) / 1000 - 0.15;
    const PeakTable table = build_peak_table(peaks_at(values), {offset, offset + 1}, bins);
    EXPECT_EQ(painted(table_regions(table), bins), first_met(table)) << "trial " << trial;
  }
}

TEST(TableRegions, AreThreeAPeak) {
  const PeakTable table = build_peak_table(peaks_at({0.2502, 0.5002, 0.7502}), {0, 1}, 4096);
  EXPECT_EQ(table_regions(table).size(), 9U);
  EXPECT_TRUE(table_regions(build_peak_table({}, {0, 1}, 4096)).empty());
}

}  // namespace
}  // namespace crest
