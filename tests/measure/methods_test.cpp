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

TEST(Methods, SetFieldsThatThereAre) {
  std::set<std::string> presets;
  for (const Method& method : methods()) {
    Preset preset;
    preset.rendering = measured_rendering(method, 0.125, {});
    preset.transfer_function = default_transfer_function();
    EXPECT_EQ(preset.rendering.step, method.s_k_per_step > 0 ? Rendering{}.step : 0.125);
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
    for (const Answer answer : answers_of(method)) answers.insert(answer);
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

// The filters are the scene's, each with an exact answer of its own; a method that sets one of another field
// has none there.
TEST(Methods, AreOfTheScenesOwnField) {
  Scene scene = scene_with_peak(0.5);
  scene.rendering.filter = Filter::bspline;
  EXPECT_EQ(measured_rendering(*find_method("xor"), 1, scene.rendering).filter, Filter::bspline);
  EXPECT_NE(why_left_out(*find_method("dvr-linear-exact"), scene), "");
  EXPECT_EQ(why_left_out(*find_method("xor"), scene), "");
  scene.rendering.filter = Filter::linear;
  EXPECT_EQ(why_left_out(*find_method("dvr-linear-exact"), scene), "");
  scene.rendering.root_filter = Filter::bspline;
  EXPECT_EQ(why_left_out(*find_method("dvr-linear-exact"), scene), "") << "no surface shows";
  EXPECT_NE(why_left_out(*find_method("xor-linear-exact"), scene), "");
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
