#include "render/classify/peak_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "presets/error.h"
#include "tests/classify/tf_of.h"

namespace crest {
namespace {

std::vector<Peak> peaks_at(std::vector<double> values) {
  std::vector<Peak> peaks(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) peaks[i].value = values[i];
  return peaks;
}

/// Bins as other GPUs may reckon them: the scale multiplied out, or by a division.
int bin_reordered(const PeakTable& t, float f) {
  const float x = std::fma(f, t.bin_scale(), -(float(t.range.min) * t.bin_scale()));
  return int(std::clamp(x, 0.0f, float(t.bins - 1)));
}
int bin_divided(const PeakTable& t, float f) {
  const float width = float(t.range.width() > 0 ? t.range.width() : 1);
  return int(std::clamp((f - float(t.range.min)) / width * float(t.bins), 0.0f, float(t.bins - 1)));
}

bool holds(const PeakTable::Cell& cell, std::size_t peak) {
  return int(peak) >= cell.first && int(peak) < cell.first + cell.count;
}

TEST(PeakTable, HoldsEveryPeakThatAnySegmentBrackets) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 400; ++trial) {
    const double min = trial % 4 == 0 ? 0 : (unit(random) - 0.5) * std::pow(10, int(random() % 60) - 30);
    const double width = std::pow(10, int(random() % 6) - 3) * std::max(std::abs(min), 1e-30);
    const ValueRange range{double(float(min)), double(float(min + width))};
    const int bins = 1 + int(random() % 512);
    std::vector<double> values;
    for (int i = 0; i < 12; ++i) values.push_back(range.min + unit(random) * range.width());
    values.push_back(double(std::nextafter(float(values[0]), INFINITY)));
    values.push_back(range.min);
    values.push_back(range.max);
    values.push_back(range.min + range.width() / bins * double(random() % unsigned(bins)));
    std::sort(values.begin(), values.end());
    const auto peaks = peaks_at(values);
    const PeakTable table = build_peak_table(peaks, range, bins);

    for (int i = 0; i < 60; ++i) {
      // Field values anywhere, and a few floats from a peak.
      const auto field = [&] {
        float f = float(range.min + unit(random) * range.width());
        if (random() % 2) {
          f = float(values[random() % values.size()]);
          for (unsigned n = random() % 4; n > 0; --n)
            f = std::nextafter(f, random() % 2 ? -INFINITY : INFINITY);
        }
        return std::clamp(f, float(range.min), float(range.max));
      };
      const float f0 = field(), f1 = field();
      for (std::size_t p = 0; p < peaks.size(); ++p) {
        const float v = float(peaks[p].value);
        if (v < std::min(f0, f1) || v > std::max(f0, f1) || v > float(range.max)) continue;
        EXPECT_TRUE(holds(table.cell(table.bin_of(f0), table.bin_of(f1)), p))
            << "trial " << trial << ": " << v << " in " << f0 << " to " << f1;
        EXPECT_TRUE(holds(table.cell(bin_reordered(table, f0), bin_divided(table, f1)), p));
      }
    }
  }
}

TEST(PeakTable, HoldsNoMoreThanTheBinsAllow) {
  std::mt19937 random(23);
  for (int trial = 0; trial < 200; ++trial) {
    const TransferFunction tf = random_tf(random, 40);
    const auto peaks = shown_peaks(find_peaks(tf));
    const int bins = 1 + int(random() % 128);
    const PeakTable table = build_peak_table(peaks, {0, 1}, bins);
    int largest = 0;
    for (int exit = 0; exit < bins; ++exit) {
      for (int entry = 0; entry < bins; ++entry) {
        const double low = double(std::min(entry, exit)) / bins,
                     high = double(std::max(entry, exit) + 1) / bins;
        const PeakTable::Cell cell = table.cell(entry, exit);
        EXPECT_EQ(cell, table.cell(exit, entry));
        largest = std::max(largest, cell.count);
        for (std::size_t p = 0; p < peaks.size(); ++p) {
          const double v = peaks[p].value;
          EXPECT_TRUE(holds(cell, p) || v < low + 1e-5 || v > high - 1e-5);
          EXPECT_FALSE(holds(cell, p) && (v < low - 1e-5 || v > high + 1e-5));
        }
      }
    }
    EXPECT_EQ(table.largest_count(), largest);
  }
}

TEST(PeakTable, ListsPeaksInTheOrderTheyAreMet) {
  const auto peaks = peaks_at({0.15, 0.35, 0.55, 0.75, 0.95});
  const PeakTable table = build_peak_table(peaks, {0, 1}, 10);
  EXPECT_EQ(peaks_met(table, 2, 6), (std::array{1, 2, -1, -1}));
  EXPECT_EQ(peaks_met(table, 6, 2), (std::array{2, 1, -1, -1}));
  EXPECT_EQ(peaks_met(table, 0, 9), (std::array{0, 1, 2, 3}));
  EXPECT_EQ(peaks_met(table, 9, 0), (std::array{4, 3, 2, 1}));
  EXPECT_EQ(peaks_met(table, 9, 9), (std::array{4, -1, -1, -1}));
  EXPECT_EQ(table.cell(9, 0).count, 5) << "none is lost";
  EXPECT_EQ(table.largest_count(), 5);
  EXPECT_EQ(peaks_met(build_peak_table(peaks, {0, 1}, 1), 0, 0), (std::array{0, 1, 2, 3}));
}

TEST(PeakTable, LeavesOutPeaksBeyondTheRange) {
  const PeakTable table = build_peak_table(peaks_at({-1, 0, 0.4, 1, 1.5}), {0, 1}, 16);
  EXPECT_EQ(peaks_met(table, 0, 15), (std::array{1, 2, 3, -1}));
  EXPECT_EQ(build_peak_table(peaks_at({-1, 3}), {0, 1}, 16).largest_count(), 0);
  EXPECT_EQ(build_peak_table({}, {0, 1}, 16).largest_count(), 0);
}

TEST(PeakTable, ARangeOfNoWidthIsOneBin) {
  const PeakTable table = build_peak_table(peaks_at({4, 5, 6}), {5, 5}, 128);
  EXPECT_EQ(table.bin_of(5), 0);
  EXPECT_EQ(peaks_met(table, 0, 0), (std::array{1, -1, -1, -1}));
  for (const double width : {1e-38, 1e-45, 6e38}) {
    const PeakTable extreme = build_peak_table({}, {0, width}, 4096);
    EXPECT_TRUE(std::isfinite(extreme.bin_scale()) && extreme.bin_scale() > 0);
    EXPECT_GE(extreme.bin_of(width), 0);
    EXPECT_LT(extreme.bin_of(width), 4096);
  }
}

TEST(PeakTable, BinsOfValuesBeyondAreTheEnds) {
  const PeakTable table = build_peak_table({}, {0, 1}, 8);
  EXPECT_EQ(table.bin_of(-1e30), 0);
  EXPECT_EQ(table.bin_of(1e30), 7);
  EXPECT_EQ(table.bin_of(1), 7);
  EXPECT_EQ(table.bin_of(std::nan("")), 0);
}

TEST(PeakTable, RefusesWhatItCannotHold) {
  EXPECT_NO_THROW(build_peak_table(std::vector<Peak>(65535), {0, 1}, 4));
  EXPECT_THROW(build_peak_table(std::vector<Peak>(65536), {0, 1}, 4), Error);
  EXPECT_THROW(build_peak_table({}, {0, 1}, 0), Error);
  EXPECT_THROW(build_peak_table({}, {0, 1}, 4097), Error);
}

}  // namespace
}  // namespace crest
