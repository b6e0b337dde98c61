#include <fmt/core.h>

#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/exact_picture.h"
#include "app/offscreen_context.h"
#include "app/picture.h"
#include "app/scene_options.h"
#include "presets/json.h"
#include "render/files/load.h"
#include "render/scene/camera.h"

namespace crest {
namespace {

struct RenderOptions {
  SceneOptions scene;
  PictureOptions picture;
};

void print_statistics(nlohmann::ordered_json json, const std::string& renderer) {
  json["renderer"] = renderer;
  fmt::print("{}\n", json.dump(2));
}

void render_on_gpu(const Scene& scene, const Camera& camera, const PictureOptions& options) {
  const OffscreenContext context(options.device);
  Renderer renderer({}, program_folder());
  const auto picture =
      measure_pictures(renderer, {scene}, camera, options.pixels(), options.frames, options.json)[0];
  write_image(options.output, picture.image, scene.rendering.background);
  print_warnings(picture.warnings);
  print_notes(picture.notes);
  if (options.json) print_statistics(statistics_json(picture, renderer, scene), context.renderer());
}

void render_exactly(const Scene& scene, const Camera& camera, const PictureOptions& options) {
  const auto picture = render_exact_pictures({scene}, camera, options.pixels(), options.output)[0];
  write_image(options.output, picture.reference.image(), scene.rendering.background);
  print_warnings(picture.warnings);
  print_notes(picture.notes);
  if (options.json) print_statistics(statistics_json(picture, scene), exact_renderer);
}

void render_picture(const RenderOptions& options) {
  const double aspect = aspect_of(options.picture.pixels());  // a wrong size is found before any work
  const auto volume = std::make_shared<const Volume>(load_volume(options.scene.volume));
  const Preset preset = options.scene.read_preset(*volume, aspect);
  const auto render = preset.rendering.engine == Engine::reference ? render_exactly : render_on_gpu;
  render(make_scene(volume, preset), camera_of(preset, volume->grid, aspect), options.picture);
}

}  // namespace

void add_render_command(Options app, Action& chosen) {
  auto options = std::make_shared<RenderOptions>();
  Options command = app.add_command("render", "Render one picture");
  command.add("VOLUME", options->scene.volume, "What to render (crest --help)").required();
  options->scene.add_to(command);
  options->picture.add_to(command);
  command.when_read([options, &chosen] { chosen = [options] { render_picture(*options); }; });
}

}  // namespace crest
