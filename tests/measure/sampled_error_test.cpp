#include "render/measure/sampled_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pictures.h"

namespace crest {
namespace {

using testing::as_exact;
using testing::filled;

constexpr glm::vec3 black(0);

const ErrorMeasure& measure_of(std::string_view id) { return *parse_target(std::string(id) + "=0").measure; }

/// Grey, with the first `wrong` pixels off by `off` in one channel.
Image with_wrong(glm::ivec2 size, int wrong, float off = 0.1f) {
  Image image = filled(size, glm::vec4(0.5f));
  for (int i = 0; i < wrong; ++i) image.pixels[std::size_t(i)].g += off;
  return image;
}

SampledError sampled(std::string_view id, glm::ivec2 size, int wrong, bool is_whole = false) {
  return sampled_error(measure_of(id), as_exact(with_wrong(size, 0)), with_wrong(size, wrong), {}, black,
                       is_whole);
}

TEST(SampledError, RaysWithNoneWrongSayAtMostFourOfThem) {
  const SampledError error = sampled("share", {50, 80}, 0);
  EXPECT_EQ(error.rays, 4000u);
  EXPECT_EQ(error.value, 0);
  EXPECT_EQ(error.low, 0);
  EXPECT_NEAR(error.high, 4.0 / 4004, 1e-12);
  EXPECT_EQ(judge(error, parse_target("share=0.001")), Verdict::met);
  EXPECT_EQ(judge(error, parse_target("share=0.0009")), Verdict::unclear);
}

TEST(SampledError, ASingleWrongRayIsUnclearAndManyAreAMiss) {
  const TargetError target = parse_target("share=0.001");
  EXPECT_EQ(judge(sampled("share", {50, 80}, 1), target), Verdict::unclear);
  EXPECT_EQ(judge(sampled("share", {50, 80}, 20), target), Verdict::missed);
  EXPECT_EQ(judge(sampled("share", {500, 80}, 20), target), Verdict::met);
}

TEST(SampledError, OfTheWholePictureAllIsKnown) {
  for (const char* id : {"share", "rmse", "max", "p999", "flip"}) {
    const SampledError error = sampled(id, {20, 10}, 3, true);
    EXPECT_EQ(error.low, error.value) << id;
    EXPECT_EQ(error.high, error.value) << id;
    EXPECT_GT(error.value, 0) << id;
  }
  const Image nothing = filled({20, 10}, glm::vec4(0));
  EXPECT_EQ(sampled_error(measure_of("share"), as_exact(nothing), nothing, {}, black, true).high, 0);
  EXPECT_EQ(judge(sampled_error(measure_of("share"), as_exact(nothing), nothing, {}, black, false),
                  default_target()),
            Verdict::unclear);
}

TEST(SampledError, APartDoesNotTellTheLargestNorWhatNeighboursMake) {
  const SampledError largest = sampled("max", {50, 80}, 1);
  EXPECT_NEAR(largest.low, 0.1, 1e-6);
  EXPECT_TRUE(std::isinf(largest.high));
  const SampledError flip = sampled("flip", {50, 80}, 1);
  EXPECT_EQ(flip.low, 0);
  EXPECT_TRUE(std::isinf(flip.high));
}

// Those of one ray are missed together, so that it is as wide as for a ray of 4000.
TEST(SampledError, OfCrossingsItIsAProportionOfRays) {
  const glm::ivec2 size{50, 80};
  Reference exact = as_exact(filled(size, glm::vec4(0.5f)));
  exact.crossings.assign(4000, 2);
  std::vector<std::uint32_t> found(4000, 2);
  found[7] = 0;
  const auto error =
      sampled_error(measure_of("missed"), exact, filled(size, glm::vec4(0.5f)), found, black, false);
  EXPECT_NEAR(error.value, 2.0 / 8000, 1e-12);
  EXPECT_GT(error.low, 0);
  EXPECT_LT(error.low, error.value);
  const SampledError of_rays = sampled("share", size, 1);
  EXPECT_NEAR(error.low, of_rays.low, 1e-12);
  EXPECT_NEAR(error.high, of_rays.high, 1e-12);
}

/// In how many of many pictures the truth lies below `low`, and above `high`.
struct Misses {
  double below = 0, above = 0;
};
Misses misses_of(std::string_view id, double wrong_share, double truth) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr int pictures = 400;
  const glm::ivec2 size{60, 50};
  const Reference exact = as_exact(filled(size, glm::vec4(0.5f)));
  Misses misses;
  for (int k = 0; k < pictures; ++k) {
    Image image = filled(size, glm::vec4(0.5f));
    for (auto& pixel : image.pixels)
      if (unit(random) < wrong_share) pixel.g += float(0.02 + 0.1 * unit(random));
    const SampledError error = sampled_error(measure_of(id), exact, image, {}, black, false);
    misses.below += (truth < error.low) / double(pictures);
    misses.above += (truth > error.high) / double(pictures);
  }
  return misses;
}

TEST(SampledError, TheWholePicturesErrorLiesBetweenItsBounds) {
  const double share = 0.01;
  for (const auto& [id, truth] :
       {std::pair("share", share), std::pair("rmse", std::sqrt(share / 4 * (0.07 * 0.07 + 0.1 * 0.1 / 12))),
        std::pair("p999", 0.11)}) {  // a tenth of the wrong ones are off by more
    const Misses misses = misses_of(id, share, truth);
    EXPECT_LT(misses.below, 0.06) << id;
    EXPECT_LT(misses.above, 0.06) << id;
  }
}

}  // namespace
}  // namespace crest
