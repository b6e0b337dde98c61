#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>

#include "presets/names.h"
#include "render/reference/reference.h"
#include "render/resources/macrocell_texture.h"
#include "tests/raycaster/fixture.h"
#include "tests/raycaster/random_view.h"

namespace crest::testing {
namespace {

constexpr glm::ivec2 size{32, 32};
/// Of 32-bit float along a ray.
constexpr double rounding = 5e-6;

Need need_of(const View& view, const Forced& forced = {}, bool statistics = false) {
  const auto& [volume, tf, rendering] = view.scene;
  const Classification classification = classify(tf, surface_range(view.scene));
  KeyedCache held(1 << 20);
  const auto occupied_share = [&](const Features& features, const TableBlur& blur) {
    return crest::occupied_share(held, {view.scene, classification, features, blur});
  };
  return find_need(*volume, classification, rendering, view.camera, size, statistics, forced, occupied_share);
}

Forced forcing(const FeatureName& feature) {
  Forced forced;
  forced.features.*feature.in = true;
  return forced;
}

Forced everything() {
  Forced forced;
  for (const FeatureName& feature : all_features()) forced.features.*feature.in = true;
  return forced;
}

bool is_listed_once(const FeatureList& list, const std::string& name) {
  const auto left_out =
      std::ranges::count(list.left_out, name, [](const auto& entry) { return entry.first; });
  return std::ranges::count(list.in, name) + left_out == 1;
}

// Every feature is in or left out for a reason, also where others are forced in.
TEST(Need, EveryFeatureIsListedOnceAndWithAReason) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed)
    for (const Forced& forced : {Forced{}, everything()})
      for (const bool statistics : {false, true}) {
        const Need need = need_of(random_view(seed), forced, statistics);
        for (const FeatureName& feature : all_features())
          ASSERT_TRUE(is_listed_once(need.list, feature.name)) << feature.name << ", seed " << seed;
        for (const auto& [name, why] : need.list.left_out) ASSERT_NE(why, "") << name << ", seed " << seed;
      }
}

/// Whether they are the same to every value of the field: at their points, and from both sides.
bool are_same_in(ValueRange field, const TransferFunction& a, const TransferFunction& b) {
  std::vector<double> values{field.min, field.max};
  for (const ControlPoint& p : a.points)
    if (p.value > field.min && p.value < field.max) values.push_back(p.value);
  return std::ranges::all_of(values, [&](double value) {
    const bool left =
        value == field.min || evaluate_left(a, value).opacity == evaluate_left(b, value).opacity;
    const bool right =
        value == field.max || evaluate_right(a, value).opacity == evaluate_right(b, value).opacity;
    return left && right;
  });
}

// Spikes are taken out of the TF wherever the field reaches one, be it only its flank.
TEST(Need, TheBaseTfIsLeftOutWhereItIsTheSame) {
  int left_out = 0;
  for (std::uint64_t seed = 0; seed < 6000; ++seed) {
    const View view = random_view(seed);
    const Need need = need_of(view);
    const Rendering& rendering = view.scene.rendering;
    if (rendering.mode != Mode::peak_xor_dvr || rendering.peak_form != PeakForm::split) continue;
    if (!need.features.dvr || need.features.base_tf) continue;
    const Classification classification = classify(view.scene.tf, surface_range(view.scene));
    EXPECT_TRUE(are_same_in(dvr_range(view.scene), classification.tf, classification.base))
        << "seed " << seed;
    ++left_out;
  }
  EXPECT_GT(left_out, 100);
}

// What is left out of the ray caster is not in the exact answer either: no surface, nothing beside surfaces,
// no ray so dark that it could end early.
TEST(Need, WhatIsLeftOutIsNotInTheExactAnswer) {
  int without_dvr = 0, without_peaks = 0, without_both = 0;
  for (std::uint64_t seed = 0; seed < 800; ++seed) {
    const View view = random_view(seed);
    const Need need = need_of(view);
    const bool dvr = need.features.dvr, peaks = need.features.peaks;
    const auto solve = [&](Answer answer) {
      return render_reference(view.scene, view.camera, {16, 16}, answer, 1e-6);
    };
    const Answer answer = answers_of(view.scene.rendering)[0];
    const Reference exact = solve(answer);
    const bool has_crossings = std::ranges::any_of(exact.crossings, [](auto count) { return count > 0; });
    EXPECT_FALSE(!peaks && has_crossings) << "seed " << seed;
    const Image nothing{exact.size, std::vector<glm::vec4>(exact.pixels.size())};
    const Image surfaces = answer == Answer::integral ? nothing : solve(Answer::crossings).image();
    EXPECT_LT(dvr ? 0 : largest_difference(exact.image(), surfaces), 1e-6) << "seed " << seed;
    const double darkest = std::ranges::max(exact.pixels, {}, &glm::dvec4::a).a;
    const bool rays_end = need.features.early_termination || view.scene.rendering.early_termination == 0;
    EXPECT_LE(darkest, 1e-6 + (rays_end ? 1 : 1 - view.scene.rendering.early_termination)) << "seed " << seed;
    without_dvr += peaks && !dvr && answer != Answer::crossings;
    without_peaks += dvr && !peaks && answer != Answer::integral;
    without_both += !dvr && !peaks;
  }
  EXPECT_GT(std::min({without_dvr, without_peaks, without_both}), 5) << "the scenes are too much alike";
}

bool shows_anything(const Image& image) {
  return std::ranges::any_of(image.pixels, [](const glm::vec4& pixel) { return pixel.a > 0; });
}

class NeedPictures : public RaycasterTest {
 protected:
  /// Draws views of these seeds, and hands them on with their pictures, of which half must show something.
  void for_views(std::uint64_t first, std::uint64_t last,
                 const std::function<void(const View&, const Image&)>& then) {
    std::uint64_t seen = 0;
    for (std::uint64_t seed = first; seed < last; ++seed) {
      SCOPED_TRACE(fmt::format("seed {}", seed));
      const View view = random_view(seed);
      const Image picture = render(view.scene, view.camera, size);
      seen += shows_anything(picture);
      then(view, picture);
    }
    EXPECT_GT(2 * seen, last - first);
  }

  /// The picture with something forced in, where that makes a difference to the ray caster at all: whether it
  /// does.
  bool expect_same(const View& view, const Forced& forced, const Image& picture, double tolerance,
                   const char* what) {
    const Need plain = need_of(view), with = need_of(view, forced);
    if (with.features == plain.features && with.tf_table.entries == plain.tf_table.entries &&
        with.peak_bins == plain.peak_bins && with.passes() == plain.passes())
      return false;
    raycaster.force(forced);
    EXPECT_LT(largest_difference(render(view.scene, view.camera, size), picture), tolerance) << what;
    raycaster.force({});
    return true;
  }
};

// However near to each other two surfaces are, a step that reaches both meets both.
TEST_F(NeedPictures, HaveBothSurfacesThatAStepReaches) {
  const Grid grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return p.z; });
  int left_out = 0, in = 0;
  for (const Placement placement : {Placement::entry_exit_corner, Placement::entry_exit})
    for (const double gap : {0.01, 0.2, 0.5, 0.8, 1.05, 1.5, 2.2, 2.5}) {
      View view{
          {volume, make_tf({point(0, 0), point(4, 0.5), point(4, 0), point(4 + gap, 0.5), point(8, 0)}), {}},
          along_z(grid, 8)};
      for (ControlPoint& p : view.scene.tf.points)
        p.surface.mode = p.opacity > 0 ? SurfaceMode::on : SurfaceMode::off;
      view.scene.rendering.mode = Mode::peak_only;
      view.scene.rendering.step = 0.95;
      view.scene.rendering.placement = placement;
      (need_of(view).features.several_peaks ? in : left_out) += 1;
      for (const glm::vec4& pixel : render(view.scene, view.camera, {4, 4}).pixels)
        ASSERT_NEAR(pixel.a, 0.75, 1e-6) << gap;
    }
  EXPECT_GT(std::min(in, left_out), 3);
}

// A shader variant takes about a fifth of a second to compile: that is what limits the number of views.
TEST_F(NeedPictures, AreTheSameWithEachFeatureForcedIn) {
  std::set<std::string> forced;
  for_views(30, 42, [&](const View& view, const Image& picture) {
    for (const FeatureName& feature : all_features())
      if (expect_same(view, forcing(feature), picture, rounding, feature.name)) forced.insert(feature.name);
  });
  EXPECT_GE(forced.size(), 10u) << "of the features that can be forced in";
}

TEST_F(NeedPictures, AreTheSameWithEverythingForcedInAndWithStatistics) {
  for_views(100, 117, [&](const View& view, const Image& picture) {
    expect_same(view, everything(), picture, rounding, "everything");
    gl::RenderTarget counted(size, true);
    raycaster.draw(view.scene, view.camera, counted);
    EXPECT_LT(largest_difference(counted.read_color(), picture), rounding);
  });
}

// A table is off by no more than it says, at each smallest spacing of a ray. A ray that ended in one pass
// goes on in the next: that is known.
TEST_F(NeedPictures, AreTheSameWithLargeTablesAndInPasses) {
  for_views(100, 117, [&](const View& view, const Image& picture) {
    const Grid& grid = view.scene.volume->grid;
    const Need need = need_of(view);
    const double spacings = glm::length(grid.box_size()) / grid.smallest_spacing();
    expect_same(view, {.features = {}, .large_tables = true}, picture,
                need.tf_table.error * spacings + rounding, "large tables");
    if (!need.needed.early_termination)
      expect_same(view, {.features = {}, .intervals_per_pass = 5}, picture, 2 * rounding, "passes");
  });
}

}  // namespace
}  // namespace crest::testing
