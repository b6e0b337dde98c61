#include "ui/value_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace crest {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(WholeRange, HoldsBothWithAMargin) {
  const ValueRange whole = whole_range({0, 100}, {-20, 50});
  EXPECT_DOUBLE_EQ(whole.min, -22.4);
  EXPECT_DOUBLE_EQ(whole.max, 102.4);
}

TEST(WholeRange, IsFiniteAndOfSomeWidthForAnyInput) {
  const double nan = std::nan("");
  for (const ValueRange volume :
       {ValueRange{7, 7}, {0, 0}, {nan, nan}, {-infinity, infinity}, {1e308, -1e308}, {-1e308, 1e308}}) {
    const ValueRange whole = whole_range(volume, {0, 0});
    EXPECT_TRUE(std::isfinite(whole.min) && std::isfinite(whole.max));
    EXPECT_TRUE(std::isfinite(whole.width()));
    EXPECT_GT(whole.width(), 0);
  }
}

TEST(Zoom, KeepsTheValueInPlaceAndStopsAtTheDeepest) {
  const ValueRange whole{0, 1};
  ValueRange visible = whole;
  const double value = 0.37;
  for (int i = 0; i < 20; ++i) {
    const double share = (value - visible.min) / visible.width();
    visible = zoom(visible, whole, value, 0.5);
    EXPECT_NEAR((value - visible.min) / visible.width(), share, 1e-6);
  }
  EXPECT_NEAR(visible.width(), std::pow(0.5, 20), 1e-15);
  for (int i = 0; i < 100; ++i) visible = zoom(visible, whole, value, 0.5);
  EXPECT_NEAR(visible.width(), deepest_zoom, 0.01 * deepest_zoom);
  EXPECT_LT(visible.min, value);
  EXPECT_GT(visible.max, value);
  for (int i = 0; i < 100; ++i) visible = zoom(visible, whole, value, 2);
  EXPECT_EQ(visible, whole);
}

TEST(Pan, StaysInsideTheWhole) {
  const ValueRange moved = pan({0.4, 0.5}, {0, 1}, 7);
  EXPECT_DOUBLE_EQ(moved.max, 1);
  EXPECT_NEAR(moved.width(), 0.1, 1e-15);
  EXPECT_EQ(pan({-5, 5}, {0, 1}, 1), (ValueRange{0, 1}));
}

TEST(AxisTicks, AreRoundAndNotTooMany) {
  const AxisTicks ticks = axis_ticks({-0.02, 1.02}, 6);
  ASSERT_EQ(ticks.ticks.size(), 6U);
  EXPECT_EQ(ticks.ticks[1].label, "0.2");
  EXPECT_DOUBLE_EQ(ticks.ticks[1].value, 0.2);
  EXPECT_EQ(ticks.offset, "");
}

TEST(AxisTicks, TellApartWhatIsFarFromZero) {
  for (const double width : {1e-4, 1e-6, 1e-9, 1e-12}) {
    const AxisTicks ticks = axis_ticks({500.123 - width / 2, 500.123 + width / 2}, 6);
    ASSERT_GE(ticks.ticks.size(), 2U) << width;
    std::set<std::string> labels;
    for (const auto& tick : ticks.ticks) {
      EXPECT_TRUE(labels.insert(tick.label).second) << tick.label << " twice at " << width;
      EXPECT_LE(tick.label.size(), 10U);
      if (!ticks.offset.empty()) {
        EXPECT_NEAR(std::stod(ticks.offset) + std::stod(tick.label), tick.value, 1e-3 * width + 2e-13);
      }
    }
  }
}

TEST(AxisTicks, SurviveAnything) {
  for (const ValueRange range :
       {ValueRange{0, 0}, {1, 0}, {-infinity, infinity}, {std::nan(""), 1}, {-1e300, 1e300}, {0, 1e-300}})
    EXPECT_LE(axis_ticks(range, 8).ticks.size(), 10U);
}

TEST(RoundToResolution, KeepsFewDigitsAndStaysClose) {
  EXPECT_EQ(round_to_resolution(0.123456789, 0.01), 0.123);
  EXPECT_EQ(round_to_resolution(123456.789, 100), 123460);
  for (const double resolution : {1e-12, 1e-5, 0.3, 1.0, 42.0, 1e6}) {
    const double value = 3.14159265358979;
    EXPECT_LE(std::abs(round_to_resolution(value, resolution) - value), resolution / 10);
  }
  EXPECT_EQ(round_to_resolution(5.5, 0), 5.5);
}

TEST(OpacityAxis, LogarithmicKeepsTheSmallApartAndTheEndsExact) {
  const OpacityAxis axis{true};
  EXPECT_EQ(axis.opacity_at(0), 0);
  EXPECT_EQ(axis.opacity_at(1), 1);
  EXPECT_EQ(axis.unit_of(0), 0);
  EXPECT_NEAR(axis.unit_of(1e-3), 0.5, 1e-12);
  EXPECT_NEAR(axis.opacity_at(axis.unit_of(3e-5)), 3e-5, 1e-15);
}

}  // namespace
}  // namespace crest
