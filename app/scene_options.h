#pragma once

#include <CLI/CLI.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/scene.h"

namespace crest {

/// The options that say what is rendered, and how: those of `render`, `compare` and the studio.
struct SceneOptions {
  std::string volume, preset;
  std::string mode, engine, illumination, step, eye, target, up, fov;  ///< as typed; empty where not given
  std::vector<std::string> sets;                                       ///< PATH=VALUE
  bool fit_range = false;

  void add_to(CLI::App& app);

  /// The preset with all that was said on the command line for this volume; without --preset, one with the
  /// default TF. Throws Error.
  Preset read_preset(const Volume& loaded) const;
};

/// The options of a picture.
struct PictureOptions {
  std::string size = "512x512", output;
  int device = -1, frames = 1;
  bool json = false;

  void add_to(CLI::App& app);
  /// Throws Error.
  glm::ivec2 pixels() const;
};

/// The preset's camera, or the one that has the whole volume in view.
Camera camera_of(const Preset& preset, const Volume& volume);

}  // namespace crest
