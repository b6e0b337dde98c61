#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/offscreen_context.h"
#include "app/picture.h"
#include "app/scene_options.h"
#include "render/volume/load.h"

namespace crest {
namespace {

struct RenderOptions {
  SceneOptions scene;
  PictureOptions picture;
};

void render_picture(const RenderOptions& options) {
  const glm::ivec2 size = options.picture.pixels();
  const auto volume = std::make_shared<const Volume>(load_volume(options.scene.volume));
  const Preset preset = options.scene.read_preset(*volume);
  const Scene scene = make_scene(volume, preset);

  const OffscreenContext context(options.picture.device);
  Raycaster raycaster;
  const auto picture = measure_pictures(raycaster, {scene}, camera_of(preset, *volume), size,
                                        options.picture.frames, options.picture.json)[0];
  write_image(options.picture.output, picture.image, preset.rendering.background);
  if (options.picture.json) {
    auto json = statistics_json(picture, raycaster, scene);
    json["renderer"] = context.renderer();
    fmt::print("{}\n", json.dump(2));
  }
}

}  // namespace

void add_render_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Render one picture");
  command->add_option("VOLUME", options->scene.volume, "What to render (crest --help)")->required();
  options->scene.add_to(*command);
  options->picture.add_to(*command);
  command->callback([options, &chosen] { chosen = [options] { render_picture(*options); }; });
}

}  // namespace crest
