#include "render/studies/knoll/scene.h"

#include <algorithm>
#include <sstream>

#include "presets/peaks.h"
#include "presets/preset_file.h"

namespace crest {

Rendering with_settings(const Rendering& rendering, std::string_view settings) {
  Preset preset;
  preset.transfer_function = default_transfer_function();  // a preset has one
  preset.rendering = rendering;
  std::istringstream words{std::string(settings)};
  for (std::string word; words >> word;) preset = set_field(preset, "rendering." + word);
  return preset.rendering;
}

TransferFunction with_peak_gain(TransferFunction tf, double gain) {
  for (const Peak& peak : find_peaks(tf))
    if (peak.shown) tf.points[peak.first_point].surface.opacity = std::min(1.0, gain * peak.opacity);
  return tf;
}

Scene measured_scene(const KnollScene& scene, const Variant& variant) {
  Scene result = scene.scene;
  result.rendering = with_settings(result.rendering, variant.settings);
  result.rendering.shading = Shading::none;
  result.rendering.early_termination = 0;
  if (variant.peak_gain != 1) result.tf = with_peak_gain(std::move(result.tf), variant.peak_gain);
  return result;
}

Camera camera_in_box(const Grid& grid, const BoxView& view) {
  const glm::dvec3 half = grid.box_size() / 2.0, middle = grid.box_min() + half;
  Camera camera;
  camera.eye = middle + half * view.eye;
  camera.target = middle + half * view.target;
  camera.up = view.up;
  camera.fov_y_degrees = view.fov_y_degrees;
  return camera;
}

}  // namespace crest
