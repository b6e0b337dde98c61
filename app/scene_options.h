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
  /// As typed; empty where not given.
  std::string mode, engine, illumination, step, eye, target, up, fov, projection;
  std::string frame;              ///< a number, or "all"
  std::vector<std::string> sets;  ///< PATH=VALUE
  bool fit_range = false;

  void add_to(Options options);
  static std::vector<std::string> option_names();
  /// A frame that the config file sets is left out where the volume has none.
  void leave_out_unused(const Options& options) const;
  /// Whether the preset is read from the standard input, which can be done once.
  bool is_preset_from_stdin() const { return preset == "-"; }
  bool has_any() const;  ///< whether anything but the volume was said

  /// The volume's source, with --frame. Throws UsageError for all frames.
  std::string source() const;
  bool is_of_all_frames() const { return frame == "all"; }
  /// source(), read.
  std::shared_ptr<const Volume> load() const;
  /// Whether the values of the preset's TF are told by the volume's range.
  bool depends_on_range(const Preset& said) const;
  /// The volume in the range of all its time steps, where that is what the preset's values depend on.
  std::shared_ptr<const Volume> in_range_of_steps(std::shared_ptr<const Volume> loaded,
                                                  const Preset& said) const;

  /// The preset with what was said on the command line and holds for every volume; without --preset, one with
  /// the default TF. Throws Error.
  Preset read_preset() const;
  /// The same with what depends on the volume: --fit-range, and the camera, for pictures of this aspect
  /// (width by height).
  Preset for_volume(Preset preset, const Volume& loaded, double aspect) const;
  /// Both.
  Preset read_preset(const Volume& loaded, double aspect) const;

 private:
  Preset with_camera(Preset preset) const;
};

/// The WIDTHxHEIGHT of --size. Throws UsageError for another text, Error for a picture that is too
/// large.
glm::ivec2 pixels_of(const std::string& size);

/// The options of a picture.
struct PictureOptions {
  std::string size = "512x512", output, format;  ///< of the file; empty: as its name ends
  int device = -1, frames = 1;
  bool json = false, exact = false;

  void add_to(Options options);
  bool is_to_stdout() const { return output == "-"; }
  /// Throws UsageError where two things would go to the standard output.
  void check() const;
  /// The preset, by the exact march where that is asked for. Throws UsageError where it does not draw what
  /// the settings mean.
  Preset with_exact(Preset preset, bool in_all_modes = false) const;
  /// Throws as pixels_of().
  glm::ivec2 pixels() const { return pixels_of(size); }
};

}  // namespace crest
