#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "app/cache_folder.h"
#include "app/offscreen_context.h"
#include "presets/error.h"
#include "presets/preset_file.h"
#include "render/files/load.h"
#include "render/measure/measure_scene.h"
#include "render/measure/pareto.h"
#include "render/measure/probe_scene.h"
#include "render/measure/timing.h"
#include "render/scene/camera.h"

// What `crest render --auto` chooses, beside the best setting of an exhaustive sweep of the same answer:
//   CREST_DATA=DIR bench_choice [SIDE [SECONDS_A_SCENE [NAME]]]
// prints a row a scene, or those whose volume has NAME in its name. Whether the target is met, and both
// times, are of the whole picture against its exact answer; the two settings are drawn turn by turn.

namespace crest {
namespace {

struct Case {
  const char *volume, *preset;
  bool is_file = false;
};
constexpr Case cases[] = {{"engine.nii.gz", "four-peaks", true},
                          {"heptane.nii.gz", "fire", true},
                          {"bonsai.nii.gz", "glass-and-bone", true},
                          {"aneurism.nrrd", "vessels-shell", true},
                          {"tooth.nrrd", "step-surface", true},
                          {"HeadMRVolume.mhd", "smooth-haze", true},
                          {"fuel_64x64x64_uint8.raw", "onion", true},
                          {"builtin:plume", "dirac-shell"},
                          {"builtin:marschner-lobb", "four-peaks"},
                          {"builtin:noise", "noisy-band"},
                          {"builtin:gyroid", "smooth-haze"},
                          {"builtin:vessels", "vessels-shell"},
                          {"builtin:sphere", "onion"}};

std::vector<Method> methods_of_answer(const Scene& scene) {
  std::vector<Method> own;
  for (const Method& method : methods()) {
    const auto answers = exact_answers_of(method, scene.rendering);
    if (measured_rendering(method, 1, scene.rendering).mode == scene.rendering.mode &&
        std::ranges::find(answers, chosen_answer(scene.rendering)) != answers.end())
      own.push_back(method);
  }
  return own;
}

struct Times {
  double chosen_ms = 0, best_ms = 0;
};

Times time_turn_by_turn(const Measurer& measurer, const Rendering& chosen, const Rendering& best) {
  std::vector<double> of_chosen, of_best;
  measurer.picture(chosen), measurer.picture(best);
  const double begin = measurer.seconds();
  while (of_best.size() < 5 || (of_best.size() < 100 && measurer.seconds() < begin + 2)) {
    of_chosen.push_back(measurer.frame(chosen).wall_ms);
    of_best.push_back(measurer.frame(best).wall_ms);
  }
  return {median(of_chosen), median(of_best)};
}

std::string text_of(std::string_view method, double step) {
  return step > 0 ? fmt::format("{} {}", method, step) : std::string(method);
}

void print_row(const Case& c, const std::string& source, int side, double seconds) {
  const auto volume = std::make_shared<const Volume>(load_volume(source));
  const Preset preset = load_preset(c.preset);
  Scene scene = make_scene(volume, preset);
  scene.rendering.shading = Shading::none;  // as a sweep measures
  scene.rendering.early_termination = 0;
  const Camera camera = camera_of(preset, volume->grid, 1);
  const glm::ivec2 size(side);

  const auto renderer = std::make_shared<Renderer>(std::filesystem::path(), program_folder());
  renderer->hold(volume);
  const Choice choice = *choose_setting(scene, size, probe_scene(renderer, scene, camera, size));

  const Measurer measurer = measure_scene(scene, camera, size, cache_folder());
  SweepSettings settings;
  settings.budget_seconds = seconds;
  settings.longest_frame_ms = std::max(2000.0, 4 * choice.setting.frame_ms);
  const auto own = methods_of_answer(scene);
  Sweep sweep(scene, measurer, settings, own);
  while (sweep.next()) {
  }
  const ExactAnswer answer = chosen_answer(scene.rendering);
  const auto best_index = cheapest_under(sweep.measured(), answer, settings.target);
  if (!best_index) {
    fmt::print("| {}, {} | {} | the sweep found nothing in {} s |\n", c.volume, c.preset,
               text_of(choice.setting.method->id, choice.setting.step), seconds);
    for (const LeftOut& left_out : sweep.left_out())
      fmt::print(stderr, "{}: {}\n", left_out.what, left_out.why);
    return;
  }
  const Measurement& best = sweep.measured()[*best_index];

  const auto picture = measurer.picture(choice.rendering);
  const ImageError error = image_error(sweep.references().at(answer), picture.image, picture.crossings,
                                       scene.rendering.background);
  const Times times = time_turn_by_turn(
      measurer, choice.rendering, measured_rendering(*find_method(best.method), best.step, scene.rendering));
  fmt::print("| {}, {} | {} | {:.2g} | {:.2g}{} | {:.3g} | {} | {:.2f} | {:.2g} |\n", c.volume, c.preset,
             text_of(choice.setting.method->id, choice.setting.step), choice.setting.error.high,
             error.compared.share, settings.target.is_met(error) ? "" : " **missed**", times.chosen_ms,
             text_of(best.method, best.step), times.chosen_ms / times.best_ms, choice.seconds);
  std::fflush(stdout);
}

void print_table(int side, double seconds, std::string_view name) {
  const OffscreenContext context;
  const char* data = std::getenv("CREST_DATA");
  fmt::print("{0}x{0}, {1}\n", side, context.renderer());
  fmt::print(
      "| scene | chosen | share at most | share | ms | best of the sweep | time by its | probe, s |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const Case& c : cases) {
    if (std::string_view(c.volume).find(name) == std::string_view::npos) continue;
    const std::string source =
        c.is_file && data ? (std::filesystem::path(data) / c.volume).string() : c.volume;
    if (c.is_file && !std::filesystem::exists(source)) {
      fmt::print("| {} | not in CREST_DATA: skipped |\n", c.volume);
      continue;
    }
    print_row(c, source, side, seconds);
  }
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  try {
    crest::print_table(argc > 1 ? std::atoi(argv[1]) : 128, argc > 2 ? std::atof(argv[2]) : 60,
                       argc > 3 ? argv[3] : "");
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_choice: {}\n", error.what());
    return 1;
  }
}
