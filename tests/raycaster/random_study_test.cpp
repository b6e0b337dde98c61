// The methods without steps in the scenes of `crest report --study random`, small.
#include <fmt/core.h>

#include <cstdlib>

#include "render/studies/random/summary.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

class RandomStudy : public RaycasterTest {};

std::vector<Method> methods_of(bool with_steps) {
  std::vector<Method> list;
  for (const Method& method : methods())
    if (method.has_step == with_steps) list.push_back(method);
  return list;
}

std::vector<RandomMeasurement> measure_seed(Renderer& renderer, std::uint64_t seed,
                                            std::span<const Method> chosen) {
  std::vector<RandomMeasurement> measurements;
  const auto scenes = random_scenes(seed);
  for (int i = 0; i < random_scene_count; ++i) {
    auto study =
        study_random_scene(renderer, scenes[std::size_t(i)], i, {.size = {32, 24}, .cache = {}}, chosen);
    EXPECT_TRUE(study.left_out.empty()) << "seed " << seed << ", scene " << i;
    for (RandomMeasurement& m : study.measurements) measurements.push_back(std::move(m));
  }
  return measurements;
}

// Of seeds 1 to 3; CREST_SEEDS=40 takes more of them.
TEST_F(RandomStudy, MethodsWithoutStepsAreExact) {
  const char* asked = std::getenv("CREST_SEEDS");
  const std::uint64_t seeds = asked ? std::strtoull(asked, nullptr, 10) : 3;
  Renderer renderer;
  const std::vector<Method> exact = methods_of(false);
  ASSERT_FALSE(exact.empty());
  double pixels = 0, crossings = 0, largest = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const auto measurements = measure_seed(renderer, seed, exact);
    for (const RandomMeasurement& m : measurements)
      if (m.wrong > 0)
        fmt::print("seed {} scene {}: {} is off by {:.3g} at ({}, {})\n", seed, m.scene, m.method,
                   m.error.compared.max, m.worst.x, m.worst.y);
    const auto summaries = summarize(measurements, [](int) { return true; });
    EXPECT_EQ(summaries.size(), exact.size());
    for (const MethodSummary& summary : summaries) {
      const std::string what = fmt::format("{}, seed {}", summary.method, seed);
      const StepSummary& all = summary.steps.at(0);
      EXPECT_GE(all.scenes, random_scene_count - 2) << what << ": too many scenes show nothing";
      EXPECT_GT(all.pixels, 2000) << what;
      EXPECT_GE(all.within(), 0.9999) << what;
      EXPECT_EQ(all.outliers, 0) << what;
      pixels += all.pixels;
      largest = std::max(largest, all.max);
      if (!all.crossings) continue;
      EXPECT_EQ(all.crossings->missed + all.crossings->invented, 0) << what;
      crossings += all.crossings->exact;
    }
  }
  fmt::print("{} seeds: {} pixels, {} crossings, the furthest pixel off by {:.2g}\n", seeds, pixels,
             crossings, largest);
}

// What the test above could not tell from a comparison of nothing: samples are off in the same scenes, less
// so at smaller steps.
TEST_F(RandomStudy, SampledMethodsAreNot) {
  Renderer renderer;
  const Method sampled[] = {*find_method("xor")};
  const auto summaries = summarize(measure_seed(renderer, 1, sampled), [](int) { return true; });
  ASSERT_EQ(summaries.size(), 1u);
  const auto& steps = summaries[0].steps;
  ASSERT_EQ(steps.size(), std::size(random_study_steps));
  EXPECT_LT(steps[0].within(), 0.95);
  EXPECT_GT(steps[1].within(), steps[0].within());
  EXPECT_GT(steps[2].within(), steps[1].within());
  EXPECT_LT(steps[2].rmse, steps[0].rmse);
}

}  // namespace
}  // namespace crest::testing
