#include "render/measure/methods.h"

#include <gtest/gtest.h>

#include <set>

#include "presets/names.h"
#include "presets/preset_file.h"
#include "scenes.h"

namespace crest {
namespace {

using testing::scene_with_peak;

TEST(Methods, HaveNamesOfTheirOwn) {
  std::set<std::string_view> ids, names, settings;
  for (const Method& method : methods()) {
    EXPECT_TRUE(ids.insert(method.id).second) << method.id;
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
    EXPECT_TRUE(settings.insert(method.settings).second) << method.settings;
    EXPECT_EQ(find_method(method.id), &method);
  }
  EXPECT_EQ(find_method("none-such"), nullptr);
}

// Each says what it cannot do, in whole sentences; "As dvr" leads to a method that says it itself.
TEST(Methods, SayWhatTheyCannotDo) {
  for (const Method& method : methods()) {
    const std::string limits(method.limits);
    ASSERT_FALSE(limits.empty()) << method.id;
    EXPECT_TRUE(limits.ends_with('.')) << method.id;
    EXPECT_EQ(limits.find_first_of("\n\";") == 0, false) << method.id;
    if (!limits.starts_with("As ")) continue;
    const Method* other = find_method(limits.substr(3, limits.find_first_of(",;.") - 3));
    ASSERT_NE(other, nullptr) << method.id << ": " << limits;
    EXPECT_FALSE(other->limits.starts_with("As ") && other->limits.find(method.id) != limits.npos);
  }
}

TEST(Methods, SetFieldsThatThereAre) {
  std::set<std::string> presets;
  for (const Method& method : methods()) {
    Preset preset;
    preset.rendering = measured_rendering(method, 0.125, {});
    preset.transfer_function = default_transfer_function();
    EXPECT_EQ(preset.rendering.step, method.s_k_per_step > 0 || !method.has_step ? Rendering{}.step : 0.125);
    EXPECT_EQ(preset.rendering.s_k, method.s_k_per_step > 0 ? 0.125 * method.s_k_per_step : Rendering{}.s_k);
    EXPECT_EQ(preset.rendering.s_k != Rendering{}.s_k, preset.rendering.sampling != Sampling::uniform);
    EXPECT_EQ(preset.rendering.unknown, "") << method.id;
    EXPECT_TRUE(presets.insert(write_preset(preset)).second) << method.id << " renders as another";
  }
}

TEST(Methods, ThereIsOneForEveryModeFormAndPlacement) {
  std::set<std::pair<Mode, PeakForm>> forms;
  std::set<Placement> placements;
  std::set<Answer> answers;
  for (const Method& method : methods()) {
    const Rendering rendering = measured_rendering(method, 1, {});
    forms.insert({rendering.mode, rendering.mode == Mode::dvr_only ? PeakForm::split : rendering.peak_form});
    placements.insert(rendering.placement);
    for (const ExactAnswer& exact : exact_answers_of(method)) answers.insert(exact.answer);
  }
  EXPECT_EQ(forms.size(), 7u);
  EXPECT_EQ(placements.size(), names_of<Placement>().size());
  EXPECT_EQ(answers.size(), 4u);
}

TEST(Methods, AreMeasuredWithoutShadingAndEarlyTermination) {
  Rendering scene;
  scene.shading = Shading::gradient;
  scene.early_termination = 0.01;
  scene.placement = Placement::eye;
  scene.max_peaks = 7;
  scene.background = {1, 0, 0};
  scene.clip_box = ClipBox{};
  const Rendering measured = measured_rendering(*find_method("both"), 0.5, scene);
  EXPECT_EQ(measured.shading, Shading::none);
  EXPECT_EQ(measured.early_termination, 0);
  EXPECT_EQ(measured.placement, Placement::entry_exit_corner);
  EXPECT_EQ(measured.max_peaks, 7);
  EXPECT_EQ(measured.background, scene.background);
  EXPECT_EQ(measured.clip_box, scene.clip_box);
  const Rendering chosen = with_method(scene, *find_method("dvr-entry"), 0.25);
  EXPECT_EQ(chosen.mode, Mode::dvr_only);
  EXPECT_EQ(chosen.placement, Placement::entry);
  EXPECT_EQ(chosen.step, 0.25);
  EXPECT_EQ(chosen.shading, Shading::gradient);
  EXPECT_EQ(chosen.early_termination, 0.01);
}

// The filters that a method does not set are the scene's; each field has exact answers of its own.
TEST(Methods, HaveTheExactAnswersOfTheirField) {
  Rendering scene;
  const auto names = [&](const char* id) {
    std::vector<std::string> list;
    for (const ExactAnswer& exact : exact_answers_of(*find_method(id), scene)) list.push_back(name_of(exact));
    return list;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names("dvr"), Names{"integral"});
  EXPECT_EQ(names("dvr-linear-exact"), Names{"integral"}) << "which is the field that linear stands for";
  EXPECT_EQ(names("dvr-bspline"), Names{"integral (bspline)"});
  EXPECT_EQ(names("xor-bc"), Names{"base+crossings (bc)"});
  EXPECT_EQ(names("xor-root-bspline"), Names{"base+crossings (linear, bspline)"});
  scene.filter = Filter::bspline;
  EXPECT_EQ(names("dvr"), Names{"integral (bspline)"});
  EXPECT_EQ(names("xor-paper"), (Names{"integral+crossings (bspline)", "base+crossings (bspline)"}));
  EXPECT_EQ(names("dvr-linear-exact"), Names{"integral"});
  scene.root_filter = Filter::linear;
  EXPECT_EQ(names("peaks"), Names{"crossings"});
  EXPECT_EQ(names("xor"), Names{"base+crossings (bspline, linear)"});
}

TEST(Methods, AreLeftOutWhereTheScenesFiltersMakeThemAnother) {
  Scene scene = scene_with_peak(0.5);
  EXPECT_EQ(why_left_out(*find_method("dvr-bspline"), scene), "");
  scene.rendering.filter = Filter::bspline;
  EXPECT_NE(why_left_out(*find_method("dvr-bspline"), scene), "");
  EXPECT_NE(why_left_out(*find_method("xor-bspline"), scene), "");
  EXPECT_EQ(why_left_out(*find_method("dvr"), scene), "");
  EXPECT_EQ(why_left_out(*find_method("dvr-linear-exact"), scene), "");
  scene.rendering.filter = Filter::linear;
  scene.rendering.root_filter = Filter::bspline;
  EXPECT_NE(why_left_out(*find_method("xor-root-bspline"), scene), "");
  EXPECT_EQ(why_left_out(*find_method("xor-bspline"), scene), "");
}

TEST(Methods, PeaksNeedASurfaceInTheVolume) {
  const Scene with = scene_with_peak(0.5), without = scene_with_peak(3);
  for (const Method& method : methods()) {
    const bool has_peaks = measured_rendering(method, 1, {}).mode != Mode::dvr_only;
    EXPECT_EQ(why_left_out(method, with), "");
    EXPECT_EQ(why_left_out(method, without).empty(), !has_peaks) << method.id;
  }
}

}  // namespace
}  // namespace crest
