#include "render/studies/placement/plane_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "presets/names.h"
#include "render/studies/placement/segments.h"

namespace crest::testing {
namespace {

/// The paper's eq. (3) as it is written: both of its integrals by quadrature, cell by cell.
double intensity_by_quadrature(const Square& square, const PlaneRay& ray) {
  using Gauss = boost::math::quadrature::gauss<double, 20>;
  const auto s = [&](double t) { return square.value(ray.at(t)); };
  const auto tau = [&](double t) { return s(t) / 2; };
  const auto ends = pieces_of(ray);
  double sum = 0, depth = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double begin = ends[i - 1], end = ends[i];
    const auto inner = [&](double t) { return depth + Gauss::integrate(tau, begin, t); };
    sum += Gauss::integrate([&](double t) { return s(t) * std::exp(-inner(t)); }, begin, end);
    depth = inner(end);
  }
  return sum;
}

TEST(Square, ExactIntensityIsEquationThree) {
  for (const Square& square : {linear_square(), curved_square()}) {
    int met = 0;
    for (const auto& ray : fan()) {
      if (!ray) continue;
      ++met;
      EXPECT_NEAR(exact_intensity(square, *ray), intensity_by_quadrature(square, *ray), 1e-12);
    }
    EXPECT_EQ(met, 100);
  }
}

// The square's outline as seen from the eye: corners at 45 degrees and its own angle.
TEST(Square, TheFanMeetsItBetweenItsCorners) {
  const double turn = Square::angle + std::atan(1.0), radius = Square::side / std::sqrt(2.0);
  const double high = std::atan2(radius * std::sin(turn), 9 + radius * std::cos(turn)),
               low = std::atan2(-radius * std::sin(turn), 9 - radius * std::cos(turn));
  const auto rays = fan();
  ASSERT_EQ(rays.size(), 120u);
  for (int i = 0; i < paper_rays; ++i) {
    const double angle = fan_angle_degrees(i) * std::atan(1.0) / 45;
    EXPECT_EQ(rays[std::size_t(i)].has_value(), angle > low && angle < high) << i;
  }
  EXPECT_TRUE(rays[105] && !rays[106]);  // the paper's missing corner is "at around ray 105"
}

TEST(Square, IsItsFormulaAtThePointsAndBilinearBetween) {
  const Square linear = linear_square(), curved = curved_square();
  for (const double x : {-1.5, -0.4, 0.0, 0.3, 1.5})
    EXPECT_NEAR(linear.value({x, 0.7}), (x + 1.5) / 3, 1e-15);
  EXPECT_NEAR(curved.value({-1.5, 1.5}), 1, 1e-15);
  EXPECT_NEAR(curved.value({0, -0.75}), 0.5, 1e-15);
  EXPECT_NEAR(curved.value({1.125, 1.125}), 0.625, 1e-15);  // the mean of 1/2, 1/2, 1/2 and 1
}

class PlanePlacement : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { study = study_plane(); }
  static const PlaneSeries& series(std::string_view field, Sum sum, Placement placement) {
    return *std::ranges::find_if(study.series, [&](const PlaneSeries& s) {
      return s.field == field && s.sum == sum && s.placement == placement;
    });
  }
  static PlaneStudy study;
};
PlaneStudy PlanePlacement::study;

TEST_F(PlanePlacement, EveryCaseIsThere) {
  EXPECT_EQ(study.series.size(), 16u);
  for (const PlaneSeries& s : study.series) ASSERT_EQ(s.measurements.size(), study_rates.size());
}

// With g = 2 tau the absorbing sum depends on the depth alone, and midpoints sum a linear field exactly: all
// that is left on the linear field is the error of the placement.
TEST_F(PlanePlacement, CornerIsExactOnTheLinearField) {
  for (const PlaneMeasurement& m :
       series("linear", Sum::absorbing, Placement::entry_exit_corner).measurements)
    EXPECT_LT(m.dense_errors.max, 1e-14) << m.rate;
}

TEST_F(PlanePlacement, CornerIsOfSecondOrderOnTheCurvedField) {
  const PlaneSeries& s = series("curved", Sum::absorbing, Placement::entry_exit_corner);
  ASSERT_TRUE(s.max_order && s.rms_order);
  EXPECT_NEAR(s.rms_order->order, 2, 0.1);
  EXPECT_NEAR(s.max_order->order, 2, 0.15);
}

TEST_F(PlanePlacement, TheOthersAreOfFirstOrderInTheWorstRay) {
  for (const std::string_view field : {"linear", "curved"})
    for (const Placement placement : {Placement::eye, Placement::entry, Placement::entry_exit}) {
      const PlaneSeries& s = series(field, Sum::absorbing, placement);
      ASSERT_TRUE(s.max_order) << field << ' ' << name_of(placement);
      EXPECT_NEAR(s.max_order->order, 1, 0.15) << field << ' ' << name_of(placement);
    }
}

// Rays without a sample are as many as a step is long, and each is off by as much: 3/2 in the mean square.
TEST_F(PlanePlacement, OverAllRaysTheMissingCornersAreOfOrderOneAndAHalf) {
  for (const std::string_view field : {"linear", "curved"}) {
    EXPECT_NEAR(series(field, Sum::absorbing, Placement::entry_exit).rms_order->order, 1.5, 0.12) << field;
    EXPECT_NEAR(series(field, Sum::absorbing, Placement::entry).rms_order->order, 1, 0.1) << field;
    EXPECT_NEAR(series(field, Sum::absorbing, Placement::eye).rms_order->order, 1, 0.1) << field;
  }
}

// What a segment emits without absorbing it itself is too much by a first order of the step, wherever the
// samples are.
TEST_F(PlanePlacement, ThePapersSumIsOfFirstOrderInAll) {
  for (const std::string_view field : {"linear", "curved"})
    for (const auto& [placement, name] : names_of<Placement>())
      EXPECT_NEAR(series(field, Sum::paper, placement).max_order->order, 1, 0.1) << field << ' ' << name;
  for (const PlaneMeasurement& m : series("linear", Sum::paper, Placement::entry_exit_corner).measurements)
    EXPECT_GE(m.errors.least, 0) << m.rate;
}

// The paper's fig. 2 (c): entry_exit drops to nothing at the edges of the square, and only there.
TEST_F(PlanePlacement, EntryExitLosesTheCorners) {
  const auto rays = fan();
  for (const PlaneMeasurement& m : series("linear", Sum::absorbing, Placement::entry_exit).measurements) {
    const double step = Square::spacing / m.rate;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (!rays[i]) continue;
      const double exact = study.fields[0].exact[i];
      if (rays[i]->exit - rays[i]->enter < step)
        EXPECT_EQ(m.intensities[i], 0) << m.rate << ' ' << i;
      else
        EXPECT_NEAR(m.intensities[i], exact, 1e-14) << m.rate << ' ' << i;
    }
    EXPECT_EQ(m.errors.unsampled > 0, m.rate < 64) << m.rate;
  }
}

// Eye and entry count too much on some rays, and too little on others.
TEST_F(PlanePlacement, EyeAndEntryAreTooBrightAndTooDark) {
  for (const Placement placement : {Placement::eye, Placement::entry})
    for (const PlaneMeasurement& m : series("linear", Sum::absorbing, placement).measurements) {
      EXPECT_GT(m.errors.greatest, 0.08 / m.rate) << name_of(placement) << ' ' << m.rate;
      EXPECT_LT(m.errors.least, -0.08 / m.rate) << name_of(placement) << ' ' << m.rate;
    }
}

}  // namespace
}  // namespace crest::testing
