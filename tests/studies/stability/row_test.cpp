#include "render/studies/stability/row.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace crest::stability {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
const Claim claim{.name = "a case", .quantity = "a quantity", .bound = 1e-5};
const Claim nothing{.name = "an empty case", .quantity = "a quantity", .bound = 0, .empty = true};

/// 10x10 pixels, of which the first `covered` show something.
Image picture(int covered) {
  Image image{{10, 10}, std::vector<glm::vec4>(100, glm::vec4(0))};
  for (int i = 0; i < covered; ++i) image.pixels[std::size_t(i)] = glm::vec4(0.5F);
  return image;
}

Worst measured(double value) {
  Worst worst;
  worst.take(value, "somewhere");
  return worst;
}

Row row_of(const Claim& row_claim, double value, const std::vector<Image>& pictures, int left_out = 0) {
  return judge(row_claim, measured(value), pictures, left_out);
}

Verdict verdict_of(const Claim& row_claim, double value, const std::vector<Image>& pictures,
                   int left_out = 0) {
  return row_of(row_claim, value, pictures, left_out).verdict;
}

TEST(StabilityRow, KeepsItsBoundOrFails) {
  const Row row = row_of(claim, 1e-5, {picture(60)});
  EXPECT_EQ(row.verdict, Verdict::pass);
  EXPECT_EQ(row.measured, 1e-5);
  EXPECT_EQ(row.at, "somewhere");
  EXPECT_EQ(row.covered, 60);
  EXPECT_EQ(row.not_finite, 0);
  EXPECT_EQ(verdict_of(claim, std::nextafter(1e-5, 1), {picture(60)}), Verdict::fail);
  EXPECT_EQ(verdict_of(claim, NAN, {picture(60)}), Verdict::fail);
  EXPECT_EQ(verdict_of(claim, INFINITY, {picture(60)}), Verdict::fail);
}

TEST(StabilityRow, ALimitIsKeptInsteadOrFails) {
  Claim limited = claim;
  limited.limit = Limit{1e-3, "rounding", {"It may be off."}};
  EXPECT_EQ(verdict_of(limited, 1e-5, {picture(60)}), Verdict::pass);
  EXPECT_EQ(verdict_of(limited, 1e-4, {picture(60)}), Verdict::limited);
  EXPECT_EQ(verdict_of(limited, 2e-3, {picture(60)}), Verdict::fail);
  EXPECT_EQ(verdict_of(limited, NAN, {picture(60)}), Verdict::fail);
}

TEST(StabilityRow, FailsWithAPixelThatIsNoNumber) {
  for (const float bad : {nan, inf, -inf})
    for (int channel = 0; channel < 4; ++channel) {
      Image broken = picture(60);
      broken.pixels[99][channel] = bad;
      // In any of its pictures, though the measurement never saw it
      for (const auto& pictures : {std::vector{broken, picture(60)}, std::vector{picture(60), broken}}) {
        const Row row = row_of(claim, 0, pictures);
        EXPECT_EQ(row.verdict, Verdict::fail) << bad << " in channel " << channel;
        EXPECT_EQ(row.not_finite, 1);
      }
      EXPECT_EQ(verdict_of(nothing, 0, {picture(0), broken}), Verdict::fail);
    }
}

TEST(StabilityRow, FailsWithAnEmptyPictureUnlessTheTruthIs) {
  EXPECT_EQ(verdict_of(claim, 0, {picture(0)}), Verdict::fail);
  const Row row = row_of(claim, 0, {picture(60), picture(0), picture(60)});
  EXPECT_EQ(row.verdict, Verdict::fail);
  EXPECT_EQ(row.covered, 0) << "of the emptiest";

  EXPECT_EQ(verdict_of(nothing, 0, {picture(0), picture(0)}), Verdict::pass);
  const Row filled = row_of(nothing, 0, {picture(0), picture(1), picture(0)});
  EXPECT_EQ(filled.verdict, Verdict::fail);
  EXPECT_EQ(filled.covered, 1) << "of the fullest";
}

TEST(StabilityRow, FailsWhereNextToNothingIsCompared) {
  EXPECT_EQ(verdict_of(claim, 0, {picture(60)}, 3), Verdict::pass);
  EXPECT_EQ(verdict_of(claim, 0, {picture(60)}, 4), Verdict::fail);
  EXPECT_EQ(verdict_of(claim, 0, {picture(100)}, 4), Verdict::pass);
  EXPECT_EQ(row_of(claim, 0, {picture(100)}, 4).left_out, 4);
}

TEST(StabilityRow, TheWorstIsRememberedWithItsPlace) {
  Worst worst;
  worst.take(0, "nowhere");
  EXPECT_EQ(worst.at, "");
  worst.take(2, "first");
  worst.take(2, "second");
  worst.take(1, "third");
  EXPECT_EQ(worst.value, 2);
  EXPECT_EQ(worst.at, "first");
  worst.take(NAN, "fourth");
  worst.take(5, "fifth");
  EXPECT_EQ(worst.value, INFINITY);
  EXPECT_EQ(worst.at, "fourth");
}

}  // namespace
}  // namespace crest::stability
