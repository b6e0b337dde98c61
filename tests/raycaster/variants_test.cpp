// Every variant of the shader that a scene can ask for compiles and links.
#include "presets/error.h"
#include "render/gl/program.h"
#include "tests/raycaster/feature_table.h"
#include "tests/raycaster/fixture.h"
#include "tests/raycaster/random_view.h"

namespace crest::testing {
namespace {

using Variants = RaycasterTest;

/// Three switches, of which the first rules the second out, and the second the third in.
Pairwise<glm::ivec3> switches() {
  std::vector<Parameter<glm::ivec3>> parameters;
  for (int axis = 0; axis < 3; ++axis) {
    parameters.push_back({std::string(1, "abc"[axis]), {}});
    for (int x = 0; x < 2; ++x)
      parameters.back().values.push_back({std::to_string(x), [=](glm::ivec3& v) { v[axis] = x; }});
  }
  return {parameters, {{"a", {"1"}, "b", {"0"}}, {"b", {"1"}, "c", {"1"}}, {"a", {"0"}, "c", {"1"}}}};
}

// Whole choices are 0-0-1, 0-1-1, 1-0-0 and 1-0-1.
TEST(PairwiseChoices, HoldEachPairThatARuleLeavesAndNoOther) {
  const auto table = switches();
  EXPECT_EQ(table.valid_pairs().size(), 3u + 3u + 3u);
  for (const Choice& choice : table.choices()) {
    EXPECT_TRUE(table.is_allowed(choice)) << table.describe(choice);
    EXPECT_EQ(table.choice_of(table.subject(choice)), choice);
  }
}

void expect_all_pairs_compile(const Pairwise<Features>& table) {
  const std::vector<Choice> choices = table.choices();
  for (const auto& pair : table.valid_pairs())
    EXPECT_TRUE(std::ranges::any_of(choices, [&](const Choice& c) { return table.holds(c, pair); }));
  for (const Choice& choice : choices) {
    EXPECT_TRUE(table.is_allowed(choice)) << table.describe(choice);
    const Features features = table.subject(choice);
    EXPECT_NO_THROW(gl::build_fullscreen_program(fragment_shader(features), shader_defines(features)))
        << table.describe(choice);
  }
}

TEST_F(Variants, EveryPairOfFeaturesThatGoTogetherCompiles) {
  expect_all_pairs_compile(feature_table());
  expect_all_pairs_compile(analytic_feature_table());
}

// Where nothing is sampled, rays that meet the box are counted.
TEST_F(Variants, CountingAloneCompiles) {
  Features features;
  features.statistics = true;
  EXPECT_NO_THROW(gl::build_fullscreen_program("raycaster.frag", shader_defines(features)));
}

// The table's rules are those of find_need: no scene asks for what they leave out.
TEST_F(Variants, AreAllThatScenesAskFor) {
  const auto sampling = feature_table(), solving = analytic_feature_table();
  int sampled = 0, solved = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    View view = random_view(seed);
    view.scene.rendering.blend_mode = BlendMode(seed / 4 % 6);
    Features features;
    try {
      features = find_need(*view.scene.volume, classify(view.scene.tf, surface_range(view.scene)),
                           view.scene.rendering, view.camera, {16, 16}, seed % 2, {},
                           [&](const Features&, const TableBlur&) { return seed % 3 ? 0.1 : 0.9; })
                     .features;
    } catch (const Error&) {
      continue;  // too many steps
    }
    if (!features.dvr && !features.peaks) continue;
    ++(features.analytic ? solved : sampled);
    const auto& table = features.analytic ? solving : sampling;
    features.base_tf = features.clip_box = false;  // no define
    const Choice choice = table.choice_of(features);
    EXPECT_EQ(std::ranges::count(choice, -1), 0) << table.describe(choice);
    EXPECT_TRUE(table.is_allowed(choice)) << table.describe(choice);
  }
  EXPECT_GT(sampled, 500);
  EXPECT_GT(solved, 50);
}

}  // namespace
}  // namespace crest::testing
