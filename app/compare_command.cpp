#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/compare.h"
#include "app/labels.h"
#include "app/offscreen_context.h"
#include "app/picture.h"
#include "app/scene_options.h"
#include "presets/names.h"
#include "render/volume/load.h"
#include "ui/studio.h"

namespace crest {
namespace {

/// The pictures in a grid of two columns, each with its label, over the background.
Image grid_of(const std::vector<MeasuredPicture>& pictures, const std::vector<std::string>& labels,
              glm::vec3 background) {
  const glm::ivec2 size = pictures.front().image.size;
  const int gap = 2, rows = int(pictures.size() + 1) / 2;
  Image grid;
  grid.size = {2 * size.x + gap, rows * size.y + (rows - 1) * gap};
  grid.pixels.assign(std::size_t(grid.size.x) * std::size_t(grid.size.y), glm::vec4(0.35f, 0.35f, 0.35f, 1));
  for (int i = 0; i < int(pictures.size()); ++i) {
    Image picture = over_background(pictures[std::size_t(i)].image, background);
    draw_label(picture, 0, 0, labels[std::size_t(i)], size.x >= 400 ? 2 : 1);
    const glm::ivec2 corner(i % 2 * (size.x + gap), i / 2 * (size.y + gap));
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) grid.at(corner.x + x, corner.y + y) = picture.at(x, y);
  }
  return grid;
}

}  // namespace

void compare_modes(const CompareOptions& options) {
  const glm::ivec2 size = options.picture.pixels();
  const auto volume = std::make_shared<const Volume>(load_volume(options.scene.volume));
  const Preset preset = options.scene.read_preset(*volume);
  std::vector<Scene> scenes;
  std::vector<std::string> labels;
  for (const Mode mode : view_modes) {
    scenes.push_back(make_scene(volume, preset));
    scenes.back().rendering.mode = mode;
    labels.emplace_back(name_of(mode));
  }

  const OffscreenContext context(options.picture.device);
  Raycaster raycaster;
  const auto pictures = measure_pictures(raycaster, scenes, camera_of(preset, *volume), size,
                                         options.picture.frames, options.picture.json);
  write_image(options.picture.output, grid_of(pictures, labels, preset.rendering.background),
              preset.rendering.background);
  if (options.picture.json) {
    nlohmann::ordered_json json;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      json["modes"].push_back(statistics_json(pictures[i], raycaster, scenes[i]));
    json["renderer"] = context.renderer();
    fmt::print("{}\n", json.dump(2));
  }
}

void add_compare_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Render the four modes side by side, labelled");
  command->add_option("VOLUME", options->scene.volume, "What to render (crest --help)")->required();
  options->scene.add_to(*command);
  options->picture.add_to(*command);
  command->callback([options, &chosen] { chosen = [options] { compare_modes(*options); }; });
}

}  // namespace crest
