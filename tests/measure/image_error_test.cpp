#include "render/measure/image_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pictures.h"
#include "presets/error.h"

namespace crest {
namespace {

using testing::as_exact;
using testing::filled;

constexpr glm::vec3 black(0);

TEST(ImageError, OfEqualPicturesIsNothing) {
  const Image image = testing::random_squares({32, 24}, 5, 1);
  const ImageError error = image_error(as_exact(image), image, {}, black);
  EXPECT_EQ(error.compared, (PixelErrors{.pixels = 32 * 24}));
  EXPECT_EQ(error.grazing, PixelErrors{});
  EXPECT_FALSE(error.crossings);
  EXPECT_EQ(error.grazing_share(), 0);
}

TEST(ImageError, ByHandOnTenPixels) {
  Image exact = filled({10, 1}, glm::vec4(0.25f, 0.25f, 0.25f, 0.5f)), image = exact;
  image.at(3, 0).g += 0.125f;  // off in one channel
  image.at(4, 0).a -= 0.25f;
  const PixelErrors errors = image_error(as_exact(exact), image, {}, black).compared;
  EXPECT_EQ(errors.pixels, 10u);
  EXPECT_DOUBLE_EQ(errors.rmse, std::sqrt((0.125 * 0.125 + 0.25 * 0.25) / 40));
  EXPECT_DOUBLE_EQ(errors.max, 0.25);
  EXPECT_DOUBLE_EQ(errors.p999, 0.25);
  EXPECT_DOUBLE_EQ(errors.share, 0.2);
}

TEST(ImageError, OnlyPixelsThatOneOfThePicturesShowsAreCompared) {
  Image exact = filled({4, 1}, glm::vec4(0)), image = exact;
  exact.at(0, 0) = glm::vec4(0.5f);
  image.at(1, 0) = glm::vec4(0.5f);
  const PixelErrors errors = image_error(as_exact(exact), image, {}, black).compared;
  EXPECT_EQ(errors.pixels, 2u);
  EXPECT_DOUBLE_EQ(errors.share, 1);
  EXPECT_DOUBLE_EQ(errors.rmse, 0.5);
}

TEST(ImageError, ThePercentilePassesOverOneInAThousand) {
  const Image exact = filled({100, 20}, glm::vec4(0.5f));  // 2000 pixels: 0.1 % are two
  Image image = exact;
  image.at(0, 0).r = 1;
  image.at(1, 0).r = 0.75;
  image.at(2, 0).r = 0.625;
  image.at(3, 0).r = 0.5f + 0.9f / 255;  // not counted in the share
  const PixelErrors errors = image_error(as_exact(exact), image, {}, black).compared;
  EXPECT_DOUBLE_EQ(errors.max, 0.5);
  EXPECT_DOUBLE_EQ(errors.p999, 0.125);
  EXPECT_DOUBLE_EQ(errors.share, 3 / 2000.0);
}

TEST(ImageError, GrazingPixelsAreComparedApart) {
  const Image exact = filled({8, 1}, glm::vec4(0.5f));
  Image image = exact;
  image.at(5, 0).r = 1;
  Reference reference = as_exact(exact);
  reference.grazing[5] = reference.grazing[6] = 1;
  const ImageError error = image_error(reference, image, {}, black);
  EXPECT_EQ(error.compared.pixels, 6u);
  EXPECT_EQ(error.compared.rmse, 0);
  EXPECT_EQ(error.grazing.pixels, 2u);
  EXPECT_DOUBLE_EQ(error.grazing.share, 0.5);
  EXPECT_DOUBLE_EQ(error.grazing_share(), 0.25);
}

TEST(ImageError, CrossingsMissedAndInventedDoNotCancel) {
  const Image exact = filled({4, 1}, glm::vec4(0.5f));
  Reference reference = as_exact(exact);
  reference.crossings = {2, 0, 1, 5};
  reference.grazing[3] = 1;
  const ImageError error = image_error(reference, exact, std::vector<std::uint32_t>{0, 1, 1, 0}, black);
  EXPECT_EQ(error.crossings, (ImageError::Crossings{3, 2, 1}));
}

TEST(ImageError, WhatIsNotANumberIsOffWithoutBound) {
  const Image exact = filled({2, 1}, glm::vec4(0.5f));
  Image image = exact;
  image.at(1, 0).b = std::numeric_limits<float>::quiet_NaN();
  const PixelErrors errors = image_error(as_exact(exact), image, {}, black).compared;
  EXPECT_TRUE(std::isinf(errors.rmse) && std::isinf(errors.max));
  EXPECT_DOUBLE_EQ(errors.share, 0.5);
  EXPECT_FALSE(parse_target("rmse=100").is_met({errors, {}, {}}));
}

TEST(ImageError, FlipIsOverTheBackground) {
  // A half-transparent black pixel is seen on white, and not on black.
  const Image exact = filled({24, 24}, glm::vec4(0, 0, 0, 0.5f)),
              image = filled({24, 24}, glm::vec4(0, 0, 0, 1));
  EXPECT_NEAR(image_error(as_exact(exact), image, {}, black).compared.flip, 0, 1e-6);
  EXPECT_GT(image_error(as_exact(exact), image, {}, glm::vec3(1)).compared.flip, 0.5);
}

TEST(TargetError, IsReadAndWritten) {
  EXPECT_EQ(to_string(default_target()), "share=0.001");
  for (const ErrorMeasure& measure : error_measures()) {
    const TargetError target = parse_target(std::string(measure.id) + "=1e-3");
    EXPECT_EQ(target.measure, &measure);
    EXPECT_EQ(target.most, 1e-3);
    EXPECT_EQ(to_string(target), std::string(measure.id) + "=0.001");
  }
  for (const char* wrong : {"", "share", "share=", "=1", "share=x", "share=-1", "Share=0.1", "share=nan",
                            "share=inf", "psnr=30", "share=0.1=2"})
    EXPECT_THROW(parse_target(wrong), Error) << wrong;
}

TEST(TargetError, IsNotMetWhereNothingIsCompared) {
  const Image empty = filled({4, 4}, glm::vec4(0));
  const ImageError error = image_error(as_exact(empty), empty, {}, black);
  EXPECT_EQ(error.compared.pixels, 0u);
  for (const ErrorMeasure& measure : error_measures()) EXPECT_TRUE(std::isnan(measure.value(error)));
  EXPECT_FALSE(default_target().is_met(error));
}

TEST(TargetError, ReadsItsMeasure) {
  ImageError error;
  error.compared = {.pixels = 10, .rmse = 0.1, .max = 0.2, .p999 = 0.3, .share = 0.4, .flip = 0.5};
  error.crossings = ImageError::Crossings{100, 60, 70};
  double expected[] = {0.4, 0.1, 0.2, 0.3, 0.5, 0.6, 0.7};
  for (std::size_t i = 0; i < error_measures().size(); ++i)
    EXPECT_DOUBLE_EQ(error_measures()[i].value(error), expected[i]) << error_measures()[i].id;
  EXPECT_TRUE(parse_target("missed=0.6").is_met(error));
  EXPECT_FALSE(parse_target("missed=0.59").is_met(error));
  error.crossings.reset();  // a picture whose crossings are not known meets no target of theirs
  EXPECT_FALSE(parse_target("missed=1").is_met(error));
}

}  // namespace
}  // namespace crest
