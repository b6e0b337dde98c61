#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/options.h"
#include "render/scene/scene.h"

namespace crest {

/// The options that say what is rendered, and how: those of `render`, `compare` and the studio.
struct SceneOptions {
  std::string volume, preset;
  std::string mode, engine, illumination, step, eye, target, up, fov;  ///< as typed; empty where not given
  std::vector<std::string> sets;                                       ///< PATH=VALUE
  bool fit_range = false;

  void add_to(Options options);
  bool has_any() const;  ///< whether anything but the volume was said

  /// The preset with all that was said on the command line for this volume; without --preset, one with the
  /// default TF. Throws Error.
  Preset read_preset(const Volume& loaded) const;
};

/// The WIDTHxHEIGHT of --size. Throws UsageError for another text, Error for a picture that is too
/// large.
glm::ivec2 pixels_of(const std::string& size);

/// The options of a picture.
struct PictureOptions {
  std::string size = "512x512", output;
  int device = -1, frames = 1;
  bool json = false;

  void add_to(Options options);
  /// Throws as pixels_of().
  glm::ivec2 pixels() const { return pixels_of(size); }
};

/// The preset's camera, or the one that has the whole volume in view.
Camera camera_of(const Preset& preset, const Volume& volume);

}  // namespace crest
