#include "render/studies/knoll/claims.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace crest::testing {
namespace {

Shot shot(std::string id, double ms, double samples = 100) {
  Shot result;
  result.variant.id = std::move(id);
  result.variant.name = result.variant.id;
  result.frame_ms = {ms, 2 * ms, 1.5 * ms};  // a machine that is slower at times, for all
  result.median_ms = 1.5 * ms;
  result.samples_per_ray = samples;
  result.error.crossings = ImageError::Crossings{};
  return result;
}

Table1Row row(const char* title, const char* dataset, std::vector<Shot> shots) {
  return {{dataset, "", 190, 120, 7.1, 11.6, 8.8}, {title, title, title, std::move(shots)}};
}

ClaimCheck check(const KnollResults& results, std::string_view id) {
  const auto all = check_claims(results);
  return *std::ranges::find(all, id, &ClaimCheck::id);
}

TEST(Judge, TheBadEndDecidesFirst) {
  const ClaimedRange cost{1.2, 2, true}, gain{1.2, 2, false};
  const auto judged = [](const ClaimedRange& range, std::vector<double> values) {
    std::vector<Evidence> evidence;
    for (const double value : values) evidence.push_back({"", value});
    return judge(range, evidence);
  };
  EXPECT_EQ(judged(cost, {1.3, 1.9}), Verdict::holds);
  EXPECT_EQ(judged(cost, {1.2 * 0.96, 2 * 1.04}), Verdict::holds) << "frames differ by 5 % by themselves";
  EXPECT_EQ(judged(cost, {1.1, 1.9}), Verdict::better);
  EXPECT_EQ(judged(cost, {1.1, 2.2}), Verdict::worse);
  EXPECT_EQ(judged(gain, {1.3, 2.2}), Verdict::better);
  EXPECT_EQ(judged(gain, {1.1, 2.2}), Verdict::worse);
  EXPECT_EQ(judged(gain, {}), Verdict::not_measured);
}

TEST(Claims, WithoutMeasurementsNoneIsDecided) {
  const auto claims = check_claims({});
  EXPECT_EQ(claims.size(), 10u);
  for (const ClaimCheck& claim : claims) {
    EXPECT_EQ(claim.verdict, Verdict::not_measured) << claim.id;
    EXPECT_EQ(claim.why, "Nothing was measured for it in this run.") << claim.id;
  }
}

// Rounds of different speed leave the ratio of one round's frames as it is.
TEST(Claims, XorAgainstPostClassification) {
  KnollResults results;
  results.table1.push_back(row("fire", "heptane (f. 3)",
                               {shot("post", 10), shot("xor-paper", 18, 150), shot("preintegrated", 11)}));
  results.table1.push_back(row("fish", "zebrafish (f. 4)",
                               {shot("post", 10), shot("xor-paper", 25, 300), shot("preintegrated", 30)}));
  const ClaimCheck all = check(results, "xor-post"), heptane = check(results, "xor-post-heptane"),
                   preintegrated = check(results, "xor-preintegrated");
  ASSERT_EQ(all.evidence.size(), 2u);
  EXPECT_DOUBLE_EQ(all.least(), 1.8);
  EXPECT_DOUBLE_EQ(all.greatest(), 2.5);
  EXPECT_EQ(all.verdict, Verdict::worse);
  EXPECT_TRUE(all.why.starts_with("fish: 2.50.")) << all.why;
  EXPECT_NE(all.why.find("300.0 field values a ray"), std::string::npos) << all.why;
  ASSERT_EQ(heptane.evidence.size(), 1u);
  EXPECT_EQ(heptane.verdict, Verdict::holds);
  EXPECT_EQ(preintegrated.verdict, Verdict::worse) << "18 / 11 on the fire";
  EXPECT_TRUE(preintegrated.why.starts_with("fire: 1.64.")) << preintegrated.why;
}

TEST(Claims, MacrocellsCountWhereTheySkip) {
  KnollResults results;
  results.table1.push_back(row("sparse", "a", {shot("xor-paper", 10), shot("xor-paper-all", 70)}));
  results.table1.push_back(row("dense", "b", {shot("xor-paper", 10), shot("xor-paper-all", 10)}));
  results.table1[0].shots.shots[0].skips = true;
  const ClaimCheck claim = check(results, "macrocells");
  ASSERT_EQ(claim.evidence.size(), 1u);
  EXPECT_DOUBLE_EQ(claim.least(), 7);
  EXPECT_EQ(claim.verdict, Verdict::better);
  EXPECT_NE(claim.why.find("hardly a macrocell is empty: dense."), std::string::npos) << claim.why;
}

SamplingRow sampling(const char* scene, const char* method, double uniform_ms, double differential_ms) {
  SamplingRow result;
  result.scene = scene;
  result.method = method;
  result.shots = {"", method, scene, {shot("uniform", uniform_ms), shot("differential", differential_ms)}};
  result.shots.shots[1].ratio = differential_ms / uniform_ms;
  return result;
}

TEST(Claims, DifferentialSamplingCloseUpAndWithTheBSpline) {
  KnollResults results;
  results.table2 = {sampling("aneurism-close", "post", 25, 10), sampling("aneurism-far", "post", 5, 10),
                    sampling("aneurism-far", "xor-bspline", 32, 10)};
  const ClaimCheck close = check(results, "differential"), bspline = check(results, "differential-bspline");
  ASSERT_EQ(close.evidence.size(), 1u) << "the far view is no part of it";
  EXPECT_DOUBLE_EQ(close.least(), 2.5);
  EXPECT_EQ(close.verdict, Verdict::holds);
  ASSERT_EQ(bspline.evidence.size(), 1u);
  EXPECT_EQ(bspline.verdict, Verdict::better);
  results.table2[0].held = HeldConstant::frame_rate;
  EXPECT_EQ(check(results, "differential").verdict, Verdict::not_measured);
}

TEST(Claims, BinsAreEnoughWhereNoMoreIsMissed) {
  KnollResults results;
  results.bins =
      ShotGroup{"bins", "", "", {shot("peaks-16", 12), shot("peaks-128", 10), shot("peaks-1024", 11)}};
  EXPECT_EQ(check(results, "bins").verdict, Verdict::holds);
  results.bins->shots[0].error.crossings->missed = 40;
  EXPECT_EQ(check(results, "bins").verdict, Verdict::holds) << "16 bins are not claimed to be enough";
  results.bins->shots[1].error.crossings->missed = 40;
  EXPECT_EQ(check(results, "bins").verdict, Verdict::worse);
}

TEST(Claims, ThePeakTableBuildsTwiceAsFast) {
  KnollResults results;
  results.builds = {{128, 1, 2.05}, {256, 4, 7.8}};
  EXPECT_EQ(check(results, "build").verdict, Verdict::holds);
  results.builds.push_back({512, 10, 90});
  EXPECT_EQ(check(results, "build").verdict, Verdict::better);
}

}  // namespace
}  // namespace crest::testing
