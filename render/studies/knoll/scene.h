#pragma once

#include <string>
#include <string_view>

#include "render/scene/scene.h"

namespace crest {

/// What Knoll et al. 2009, Table 1, prints of a scene, at the paper's own picture sizes.
struct PaperRow {
  std::string_view dataset, dimensions;
  double samples_per_ray = 0, dvr_samples_per_ray = 0;
  double fps_peaks = 0, fps_post = 0, fps_preintegrated = 0;
};

/// A scene of the study as one camera sees it.
struct KnollScene {
  std::string id;      ///< "heptane-3": in files
  std::string title;   ///< "heptane (fig. 3)"
  std::string volume;  ///< what is rendered, as `crest render` takes it
  std::string note;    ///< how it differs from the paper's data; empty where it is the paper's own
  std::string preset;  ///< the name of its transfer function's
  Scene scene;
  Camera camera;
};

/// A way to render a scene.
struct Variant {
  std::string id, name;  ///< "xor-paper": in files; for people
  std::string settings;  ///< fields of "rendering", as in "mode=DVR_ONLY sampling=differential"
  double peak_gain = 1;  ///< what the opacities of surfaces are multiplied with; at most 1 comes of it
};

/// `rendering` with fields set as in "mode=DVR_ONLY s_k=4". Throws Error as set_field.
Rendering with_settings(const Rendering& rendering, std::string_view settings);

/// The TF with the opacities of its surfaces, not of its points, multiplied.
TransferFunction with_peak_gain(TransferFunction tf, double gain);

/// The scene in a variant, as it is measured: shading, which has no exact answer, and early termination,
/// which adds an error of its own, are off.
Scene measured_scene(const KnollScene& scene, const Variant& variant);

/// A camera in units of the volume's box: its middle is 0, its faces are at -1 and 1.
struct BoxView {
  glm::dvec3 eye{0}, target{0}, up{0, 0, 1};
  double fov_y_degrees = 30;
};
Camera camera_in_box(const Grid& grid, const BoxView& view);

}  // namespace crest
