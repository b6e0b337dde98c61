#include "render/studies/random/summary.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crest {
namespace {

RandomMeasurement measured(int scene, const char* method, double step, Answer answer, std::size_t pixels,
                           std::size_t wrong, double rmse) {
  RandomMeasurement m;
  m.scene = scene;
  m.method = method;
  m.step = step;
  m.answer = answer;
  m.error.compared.pixels = pixels;
  m.error.compared.share = pixels > 0 ? double(wrong) / double(pixels) : 0;
  m.error.compared.rmse = rmse;
  m.error.compared.max = 2 * rmse;
  m.wrong = wrong;
  m.outliers = wrong / 2;
  return m;
}

constexpr auto every_scene = [](int) { return true; };

TEST(RandomSummary, JoinsThePixelsOfAllScenes) {
  std::vector<RandomMeasurement> list;
  for (const double step : {0.125, 0.5}) {  // in any order
    list.push_back(
        measured(0, "xor", step, Answer::base_and_crossings, 100, step > 0.2 ? 10 : 2, 0.4 * step));
    list.push_back(
        measured(3, "xor", step, Answer::base_and_crossings, 300, step > 0.2 ? 90 : 0, 0.8 * step));
  }
  list.push_back(measured(5, "xor", 0.5, Answer::base_and_crossings, 0, 0, 0));  // nothing to compare
  list[0].error.crossings = {7, 2, 1};
  list[1].error.crossings = {5, 1, 0};
  const auto summaries = summarize(list, every_scene);
  ASSERT_EQ(summaries.size(), 1u);
  const MethodSummary& xor_ = summaries[0];
  ASSERT_EQ(xor_.steps.size(), 2u);
  const StepSummary &coarse = xor_.steps[0], &fine = xor_.steps[1];
  EXPECT_EQ(coarse.step, 0.5);
  EXPECT_EQ(coarse.scenes, 2);
  EXPECT_EQ(coarse.pixels, 400);
  EXPECT_DOUBLE_EQ(coarse.within(), 0.75);
  EXPECT_EQ(coarse.outliers, 5 + 45);
  EXPECT_DOUBLE_EQ(coarse.rmse, std::sqrt((0.2 * 0.2 * 100 + 0.4 * 0.4 * 300) / 400));
  EXPECT_DOUBLE_EQ(coarse.max, 0.8);
  EXPECT_EQ(coarse.worst_scene, 3);
  EXPECT_DOUBLE_EQ(coarse.worst_within, 0.7);
  EXPECT_FALSE(coarse.crossings);
  EXPECT_EQ(fine.worst_scene, 0);
  EXPECT_DOUBLE_EQ(fine.worst_within, 0.98);
  EXPECT_EQ(fine.crossings, (ImageError::Crossings{12, 3, 1}));
  ASSERT_EQ(xor_.orders.size(), 1u);
  EXPECT_NEAR(*xor_.orders[0], 1, 1e-12);
}

TEST(RandomSummary, TellsAnswersMethodsAndScenesApart) {
  const std::vector<RandomMeasurement> list{
      measured(0, "xor-paper", 0.5, Answer::integral_and_crossings, 10, 5, 0.1),
      measured(0, "xor-paper", 0.5, Answer::base_and_crossings, 10, 4, 0.1),
      measured(0, "xor-analytic", 0, Answer::base_and_crossings, 10, 0, 0),
      measured(1, "xor-paper", 0.5, Answer::base_and_crossings, 10, 2, 0.1)};
  const auto all = summarize(list, every_scene);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].answer, ExactAnswer(Answer::integral_and_crossings));
  EXPECT_EQ(all[1].steps[0].wrong, 6);
  EXPECT_EQ(all[2].method, "xor-analytic");
  EXPECT_TRUE(all[2].orders.empty());
  const auto second = summarize(list, [](int scene) { return scene == 1; });
  ASSERT_EQ(second.size(), 1u);
  EXPECT_EQ(second[0].steps[0].wrong, 2);
  EXPECT_EQ(find_summary(all, "xor-analytic"), &all[2]);
  EXPECT_EQ(find_summary(all, "dvr"), nullptr);
}

TEST(RandomSummary, AnErrorOfRoundingHasNoOrder) {
  const std::vector<RandomMeasurement> list{measured(0, "dvr", 0.5, Answer::integral, 10, 0, 1e-3),
                                            measured(0, "dvr", 0.125, Answer::integral, 10, 0, 1e-6),
                                            measured(0, "dvr", 0.03125, Answer::integral, 10, 0, 1e-6)};
  const auto orders = summarize(list, every_scene).at(0).orders;
  ASSERT_EQ(orders.size(), 2u);
  EXPECT_FALSE(orders[0]);
  EXPECT_FALSE(orders[1]);
}

TEST(RandomSummary, TheBestSampledMethodHasStepsAndBothSurfacesAndVolume) {
  const std::vector<RandomMeasurement> list{
      measured(0, "dvr", 0.5, Answer::integral, 10, 0, 0),
      measured(0, "xor-analytic", 0, Answer::base_and_crossings, 10, 0, 0),
      measured(0, "xor", 0.5, Answer::base_and_crossings, 10, 1, 0),
      measured(0, "xor", 0.125, Answer::base_and_crossings, 10, 3, 0),
      measured(0, "xor-pre", 0.5, Answer::base_and_crossings, 10, 4, 0),
      measured(0, "xor-pre", 0.125, Answer::base_and_crossings, 10, 2, 0),
      measured(0, "xor-linear-exact", 0.5, Answer::base_and_crossings, 10, 5, 0),
      measured(0, "xor-linear-exact", 0.125, Answer::base_and_crossings, 10, 2, 0)};
  const auto summaries = summarize(list, every_scene);
  ASSERT_NE(best_sampled(summaries), nullptr);
  EXPECT_EQ(best_sampled(summaries)->method, "xor-pre");
  EXPECT_EQ(best_sampled(std::span(summaries).first(2)), nullptr);
}

TEST(RandomMeasurement, LeavesGrazingPixelsOut) {
  Reference exact{{2, 2}, std::vector<glm::dvec4>(4, glm::dvec4(0.5)), {1, 1, 0, 0}, {0, 0, 0, 1}};
  Image image{{2, 2}, std::vector<glm::vec4>(4, glm::vec4(0.5f))};
  image.pixels[1].g = 0.51f;
  image.pixels[2].r = 0.8f;
  image.pixels[3].r = 1;  // grazes
  const std::vector<std::uint32_t> crossings{1, 0, 2, 0};
  const RandomMeasurement m = compare_random(exact, image, crossings);
  EXPECT_EQ(m.error.compared.pixels, 3u);
  EXPECT_EQ(m.wrong, 2u);
  EXPECT_EQ(m.outliers, 1u);
  EXPECT_EQ(m.worst, glm::ivec2(0, 1));
  EXPECT_EQ(m.error.crossings, (ImageError::Crossings{2, 1, 2}));
}

}  // namespace
}  // namespace crest
