#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "presets/preset_file.h"
#include "program.h"
#include "render/measure/probe_scene.h"
#include "render/scene/camera.h"
#include "render/volume/builtin.h"
#include "tests/debug_context.h"

namespace crest {
namespace {

constexpr glm::ivec2 size{144, 128};

struct Chosen {
  Choice choice;
  ImageError error;  ///< of the whole picture, against the whole exact one
};

Chosen choose(const char* volume_name, const char* preset_name, const ChoiceSettings& settings) {
  const testing::DebugContext context;
  const auto volume = std::make_shared<const Volume>(make_builtin(volume_name));
  const Preset preset = load_preset(preset_name);
  Scene scene = make_scene(volume, preset);
  scene.rendering.shading = Shading::none;  // which has no exact answer
  scene.rendering.early_termination = 0;
  const Camera camera = whole_volume_camera(volume->grid, aspect_of(size));
  const auto renderer = std::make_shared<Renderer>();
  Chosen chosen;
  chosen.choice = choose_setting(scene, size, probe_scene(renderer, scene, camera, size), settings).value();
  scene.rendering = chosen.choice.rendering;
  gl::RenderTarget target(size, false);
  renderer->draw(scene, camera, target);
  const Reference exact = render_reference(scene, camera, size, chosen_answer(scene.rendering).answer);
  chosen.error = image_error(exact, target.read_color(), {}, std::nullopt);
  return chosen;
}

TEST(ChoiceOnDevice, MeetsTheTargetOnSpikesAndOnHaze) {
  for (const auto& [volume, preset] :
       {std::pair("plume?n=40", "dirac-shell"), {"gyroid?n=40", "smooth-haze"}})
    for (const char* target : {"share=0.001", "share=0.02", "rmse=0.002"}) {
      const ChoiceSettings settings{.target = parse_target(target)};
      const Chosen chosen = choose(volume, preset, settings);
      EXPECT_TRUE(chosen.choice.meets_target) << volume << target;
      EXPECT_TRUE(settings.target.is_met(chosen.error))
          << volume << " " << target << " " << name_of(chosen.choice.setting)
          << settings.target.measure->value(chosen.error);
      EXPECT_GT(chosen.choice.setting.frame_ms, 0);
    }
}

class AutoCommand : public test::ProgramTest {
 protected:
  std::vector<std::string> render(const std::vector<std::string>& more) const {
    using test::operator+;
    return std::vector<std::string>{
               "render", "builtin:gyroid?n=24", "--preset", "smooth-haze", "--size", "64x64",
               "-o",     path("a.png")} +
           more;
  }
};

TEST_F(AutoCommand, SaysWhatItChose) {
  const std::string line = output_of(render({"--auto"}));
  EXPECT_EQ(line.find("auto: dvr-"), 0u) << line;
  EXPECT_NE(line.find("predicted share "), std::string::npos) << line;
  EXPECT_EQ(std::ranges::count(line, '\n'), 1);

  const auto json = json_of(render({"--auto", "--json", "--target-error", "rmse=0.01"}));
  const auto& choice = json.at("auto");
  EXPECT_EQ(choice.at("target_error"), "rmse=0.01");
  EXPECT_TRUE(choice.at("meets_target"));
  EXPECT_LE(choice.at("error").get<double>(), 0.01);
  EXPECT_FALSE(choice.at("tried").empty());
  EXPECT_EQ(json.at("mode"), "DVR_ONLY");
}

TEST_F(AutoCommand, SaysWhereNothingWillDo) {
  const auto outcome = run(render({"--auto", "--budget", "0.0001"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("crest: note: --auto: no setting tried draws a frame in 0.0001 ms"),
            std::string::npos)
      << outcome.err;
}

TEST_F(AutoCommand, WrongOptions) {
  expect_error(2, render({"--target-error", "share=0.01"}), {"--target-error", "--auto"});
  expect_error(2, render({"--budget", "10"}), {"--budget", "--auto"});
  expect_error(2, render({"--auto", "--step", "0.5"}), {"--auto", "--step"});
  expect_error(2, render({"--auto", "--engine", "vdls"}), {"--auto", "--engine"});
  expect_error(2, render({"--auto", "--budget", "fast"}), {"--budget", "fast"});
  expect_error(2, render({"--auto", "--target-error", "much=1"}), {"--target-error", "much=1"});
  expect_error(1, render({"--auto", "--illumination", "maximum"}), {"maximum", "semi_transparent"});
}

}  // namespace
}  // namespace crest
