#include <fmt/core.h>

#include <array>

#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/compare.h"
#include "app/exact_picture.h"
#include "app/offscreen_context.h"
#include "app/picture.h"
#include "app/picture_grid.h"
#include "app/picture_output.h"
#include "app/scene_options.h"
#include "app/sources.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/names.h"
#include "render/scene/camera.h"
#include "ui/studio.h"

namespace crest {
namespace {

/// A picture with what stands on it, and its statistics.
struct LabelledPicture {
  Image image;
  std::string label;
  nlohmann::ordered_json statistics;
  std::vector<std::string> warnings, notes;
};

struct ComparedPictures {
  std::vector<LabelledPicture> pictures;
  std::string renderer;
};

ComparedPictures compare_on_gpu(const std::vector<Scene>& scenes, const Camera& camera,
                                const PictureOptions& options) {
  const OffscreenContext context(options.device);
  Renderer renderer({}, program_folder());
  auto measured = measure_pictures(renderer, scenes, camera, options.pixels(), options.frames, options.json);
  ComparedPictures comparison{{}, context.renderer()};
  auto& pictures = comparison.pictures;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Rendering& rendering = scenes[i].rendering;
    std::string label(name_of(rendering.mode));
    if (rendering.engine == Engine::vdls) label += ": vdls";
    pictures.push_back(
        {std::move(measured[i].image), std::move(label), {}, measured[i].warnings, measured[i].notes});
    if (options.json) pictures.back().statistics = statistics_json(measured[i], renderer, scenes[i]);
  }
  return comparison;
}

ComparedPictures compare_exactly(const std::vector<Scene>& scenes, const Camera& camera,
                                 const PictureOptions& options) {
  const auto exact = render_exact_pictures(scenes, camera, options.pixels(), options.output);
  ComparedPictures comparison{{}, exact_renderer};
  for (std::size_t i = 0; i < scenes.size(); ++i)
    comparison.pictures.push_back(
        {exact[i].reference.image(),
         fmt::format("{}: {}", name_of(scenes[i].rendering.mode), name_of(exact[i].answer)),
         statistics_json(exact[i], scenes[i]), exact[i].warnings, exact[i].notes});
  return comparison;
}

}  // namespace

void compare_modes(const CompareOptions& options) {
  const double aspect = aspect_of(options.picture.pixels());  // a wrong size is found before any work
  require_other_files({{"--output", options.picture.output}}, {options.scene.volume, options.scene.preset});
  require_output(options.picture);
  const auto loaded = options.scene.load();
  const Preset said = options.scene.read_preset();
  const auto volume = options.scene.in_range_of_steps(loaded, said);
  const Preset preset = options.picture.with_exact(options.scene.for_volume(said, *volume, aspect), true);
  std::vector<Scene> scenes;
  for (const Mode mode : view_modes) {
    scenes.push_back(make_scene(volume, preset));
    scenes.back().rendering = in_mode(scenes.back().rendering, mode);
  }
  const auto compare = preset.rendering.engine == Engine::reference ? compare_exactly : compare_on_gpu;
  ComparedPictures comparison = compare(scenes, camera_of(preset, volume->grid, aspect), options.picture);
  std::vector<LabelledImage> labelled;
  for (LabelledPicture& picture : comparison.pictures)
    labelled.push_back({std::move(picture.image), picture.label});
  write_picture(options.picture, picture_grid(labelled, 2, preset.rendering.background),
                preset.rendering.background);
  std::vector<std::string> warnings, notes;
  for (const auto& picture : comparison.pictures) {
    warnings.insert(warnings.end(), picture.warnings.begin(), picture.warnings.end());
    notes.insert(notes.end(), picture.notes.begin(), picture.notes.end());
  }
  print_warnings(warnings);
  print_notes(notes);
  if (!options.picture.json) return;
  nlohmann::ordered_json json;
  for (auto& picture : comparison.pictures) json["modes"].push_back(std::move(picture.statistics));
  json["renderer"] = comparison.renderer;
  fmt::print("{}\n", pretty(json));
}

void add_compare_command(Options app, Command& chosen) {
  auto options = std::make_shared<CompareOptions>();
  Options command = app.add_command("compare", "Render the four modes side by side, labelled", "Pictures");
  command.add("VOLUME", options->scene.volume, "What to render (crest --help)")
      .required()
      .offers(builtin_sources());
  options->scene.add_to(command);
  options->picture.add_to(command);
  command.add_example("crest compare builtin:plume --preset fire --step 0.25 -o fire.png --json");
  command.when_read([options, command, &chosen] {
    if (options->picture.is_to_stdout()) command.leave_out({"--json"});
    options->scene.leave_out_unused(command);
    options->picture.check();
    chosen = [options] { compare_modes(*options); };
  });
}

}  // namespace crest
