#include "presets/peaks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/classify/tf_of.h"

namespace crest {
namespace {

std::vector<double> values_of(const std::vector<Peak>& peaks) {
  std::vector<double> values;
  for (const Peak& peak : peaks) values.push_back(peak.value);
  return values;
}
using Values = std::vector<double>;

TEST(Peaks, AreInnerPointsHigherThanBothNeighbours) {
  const auto peaks = find_peaks(tf_of({{0, 0}, {1, 0.5}, {2, 0.1}, {3, 0.9}, {4, 0.2}}));
  EXPECT_EQ(values_of(peaks), (Values{1, 3}));
  EXPECT_EQ(peaks[0].left, 0u);
  EXPECT_EQ(peaks[0].right, 2u);
  EXPECT_EQ(peaks[0].width, 2);
  EXPECT_EQ(peaks[0].opacity, 0.5);
  EXPECT_TRUE(peaks[0].detected && peaks[0].shown && !peaks[0].spike);
}

TEST(Peaks, AreNoneAtTheEndsOnSlopesOrWithoutPoints) {
  EXPECT_TRUE(find_peaks(TransferFunction{}).empty());
  EXPECT_TRUE(find_peaks(tf_of({{0, 1}})).empty());
  EXPECT_TRUE(find_peaks(tf_of({{0, 1}, {1, 0.2}, {2, 1}})).empty());
  EXPECT_TRUE(find_peaks(tf_of({{0, 0}, {1, 0.5}, {2, 0.7}, {3, 1}})).empty());
  EXPECT_TRUE(find_peaks(tf_of({{0, 1}, {0, 1}, {1, 0}})).empty());
}

TEST(Peaks, AStepsCornerIsNoneButATrueSpikeIs) {
  EXPECT_TRUE(find_peaks(tf_of({{0, 0}, {1, 0}, {1, 0.9}, {2, 0.1}})).empty());
  EXPECT_TRUE(find_peaks(tf_of({{0, 0.2}, {1, 0.9}, {1, 0}, {2, 0}})).empty());
  TransferFunction tf = tf_of({{0, 0}, {1, 0.1}, {1, 0.9}, {1, 0}, {2, 0.5}});
  tf.points[2].color = {1, 0, 0};
  const auto peaks = find_peaks(tf);
  ASSERT_EQ(values_of(peaks), (Values{1}));
  EXPECT_EQ(peaks[0].width, 0);
  EXPECT_TRUE(peaks[0].spike);
  EXPECT_EQ(peaks[0].color, glm::dvec3(1, 0, 0)) << "its own, not that of the last point at its value";
}

TEST(Peaks, TheSamePointTwiceIsOnePeak) {
  const auto peaks = find_peaks(tf_of({{0, 0}, {1, 0.5}, {1, 0.5}, {2, 0}}));
  ASSERT_EQ(values_of(peaks), (Values{1}));
  EXPECT_EQ(peaks[0].first_point, 1u);
  EXPECT_EQ(peaks[0].last_point, 2u);
  EXPECT_EQ(peaks[0].width, 2);
}

TEST(Peaks, ANarrowPlateauIsOnePeakAtItsMiddle) {
  TransferFunction tf = tf_of({{0, 0}, {1, 0.5}, {1.1, 0.5}, {1.2, 0.5}, {2, 0}});
  tf.points[1].color = {1, 0, 0};
  tf.points[2].color = {0, 1, 0};
  EXPECT_TRUE(find_peaks(tf).empty()) << "a flat top is not strictly higher";
  tf.plateau_width = 0.25;
  const auto peaks = find_peaks(tf);
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_DOUBLE_EQ(peaks[0].value, 1.1);
  EXPECT_NEAR(peaks[0].color.g, 1, 1e-12);
  EXPECT_EQ(peaks[0].first_point, 1u);
  EXPECT_EQ(peaks[0].last_point, 3u);
  tf.plateau_width = tf.points[3].value - tf.points[1].value;
  EXPECT_TRUE(find_peaks(tf).empty()) << "narrower, not as wide";
}

TEST(Peaks, NeedTheProminence) {
  TransferFunction tf = tf_of({{0, 0.1}, {1, 0.5}, {2, 0.4}, {3, 0.9}, {4, 0.8}, {5, 0.85}, {6, 0.2}});
  const auto peaks = find_peaks(tf);
  ASSERT_EQ(values_of(peaks), (Values{1, 3, 5}));
  EXPECT_DOUBLE_EQ(peaks[0].prominence, 0.1);
  EXPECT_DOUBLE_EQ(peaks[1].prominence, 0.7) << "0.9 over the higher of the two ends' minima, 0.1 and 0.2";
  EXPECT_NEAR(peaks[2].prominence, 0.05, 1e-15);
  tf.min_prominence = 0.09;
  EXPECT_EQ(values_of(find_peaks(tf)), (Values{1, 3}));
}

TEST(Peaks, ProminenceIsThatOfAPlainSearch) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 500; ++trial) {
    const TransferFunction tf = random_tf(random, 30);
    for (const Peak& peak : find_peaks(tf)) {
      double left = 2, right = 2;
      const double top = tf.points[peak.first_point].opacity;
      for (std::size_t i = peak.first_point + 1; i-- > 0 && tf.points[i].opacity <= top;)
        left = std::min(left, tf.points[i].opacity);
      for (std::size_t i = peak.last_point; i < tf.points.size() && tf.points[i].opacity <= top; ++i)
        right = std::min(right, tf.points[i].opacity);
      EXPECT_EQ(peak.prominence, top - std::max(left, right));
    }
  }
}

TEST(Peaks, APersonMakesAnyPointASurfaceOrNone) {
  TransferFunction tf = tf_of({{0, 0.3}, {1, 0.5}, {2, 0.1}, {3, 0.1}, {3, 0.8}, {4, 0.8}});
  tf.points[1].surface.mode = SurfaceMode::off;
  tf.points[0].surface.mode = SurfaceMode::on;
  tf.points[2].surface = {SurfaceMode::on, 0.75};
  tf.points[4].surface.mode = SurfaceMode::on;
  const auto peaks = find_peaks(tf);
  EXPECT_EQ(values_of(peaks), (Values{0, 1, 2, 3}));
  EXPECT_TRUE(peaks[1].detected && !peaks[1].shown);
  EXPECT_TRUE(!peaks[2].detected && peaks[2].shown && !peaks[2].spike);
  EXPECT_EQ(peaks[2].opacity, 0.75);
  EXPECT_EQ(peaks[0].left, 0u);
  EXPECT_EQ(peaks[0].right, 1u);
  EXPECT_EQ(peaks[3].opacity, 0.8);
  EXPECT_EQ(values_of(shown_peaks(peaks)), (Values{0, 2, 3}));
}

TEST(Peaks, ASpikeIsAHundredthOfTheSpan) {
  const auto spike = find_peaks(tf_of({{0, 0}, {0.495, 0}, {0.5, 0.9}, {0.505, 0}, {1, 0}}));
  EXPECT_TRUE(spike.at(0).spike);
  const auto body = find_peaks(tf_of({{0, 0}, {0.495, 0}, {0.5, 0.9}, {0.5051, 0}, {1, 0}}));
  EXPECT_FALSE(body.at(0).spike);
}

TEST(Peaks, PointsOnAFlanksLineChangeNothing) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 20000; ++trial) {
    TransferFunction tf = random_tf(random, 12);
    if (trial % 2) tf = remap_values(tf, {0, 1}, {1e3, 1e3 + 1});
    tf.plateau_width = trial % 3 ? 0 : 0.2;
    TransferFunction denser = tf;
    for (int i = 0; i < 10; ++i) {
      const std::size_t at = random() % denser.points.size();
      ControlPoint extra = denser.points[at];
      if (at + 1 < denser.points.size() && random() % 4) {
        const ControlPoint& next = denser.points[at + 1];
        extra.value = std::lerp(extra.value, next.value, std::max(1e-6, std::pow(unit(random), 8)));
        if (extra.value < next.value) {
          const Classified between = evaluate(denser, extra.value);
          extra.opacity = between.opacity;
          extra.color = between.color;
        } else {
          extra = next;
        }
      }
      denser.points.insert(denser.points.begin() + std::ptrdiff_t(at) + 1, extra);
    }
    const auto expected = find_peaks(tf), found = find_peaks(denser);
    ASSERT_EQ(values_of(found), values_of(expected)) << "trial " << trial;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].spike, expected[i].spike) << "trial " << trial;
      // A corner, and a point hardly beside it, may be taken for one another.
      EXPECT_NEAR(found[i].width, expected[i].width, 1e-9 * tf.range().width());
      EXPECT_EQ(found[i].prominence, expected[i].prominence);
      EXPECT_EQ(found[i].opacity, expected[i].opacity);
    }
  }
}

TEST(BaseTransferFunction, LosesItsShownSpikesAndNothingElse) {
  TransferFunction tf = tf_of({{0, 0.2},
                               {0.3, 0.2},
                               {0.3005, 0.55},
                               {0.301, 0.9},
                               {0.302, 0.2},
                               {0.5, 0.2},
                               {0.7, 0.8},
                               {0.9, 0},
                               {0.9, 1},
                               {0.9, 0},
                               {1, 0}});
  const TransferFunction base = base_transfer_function(tf, find_peaks(tf));
  EXPECT_EQ(base.points.size(), tf.points.size() - 3);
  EXPECT_EQ(evaluate(base, 0.301).opacity, 0.2);
  EXPECT_EQ(evaluate(base, 0.7).opacity, 0.8) << "a wide peak keeps its body";
  EXPECT_TRUE(find_peaks(base).at(0).value == 0.7 && find_peaks(base).size() == 1);
  tf.points[3].surface.mode = SurfaceMode::off;
  EXPECT_EQ(evaluate(base_transfer_function(tf, find_peaks(tf)), 0.301).opacity, 0.9)
      << "not shown: still volume";
}

TEST(BaseTransferFunction, KeepsTheFootThatTwoSpikesShare) {
  const TransferFunction tf =
      tf_of({{0, 0}, {0.5, 0.1}, {0.501, 0.8}, {0.502, 0.3}, {0.503, 0.9}, {0.504, 0.1}, {1, 0}});
  const TransferFunction base = base_transfer_function(tf, find_peaks(tf));
  EXPECT_EQ(base.points.size(), 5u);
  EXPECT_EQ(evaluate(base, 0.502).opacity, 0.3);
}

TEST(Peaks, OfAHundredThousandPoints) {
  TransferFunction tf;
  for (int i = 0; i < 100000; ++i) {
    tf.points.emplace_back();
    tf.points.back().value = i;
    tf.points.back().opacity = i % 2 ? 1.0 - i * 1e-5 : 0;
  }
  EXPECT_EQ(find_peaks(tf).size(), 49999u);
}

}  // namespace
}  // namespace crest
