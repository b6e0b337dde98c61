#include "render/studies/vdls/scenes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "presets/error.h"
#include "render/files/load.h"
#include "render/scene/camera.h"
#include "render/volume/builtin.h"
#include "render/volume/random.h"

namespace crest {
namespace {

ControlPoint point(double value, double opacity, glm::dvec3 color) {
  ControlPoint result;
  result.value = value;
  result.opacity = opacity;
  result.color = color;
  return result;
}

/// What stands for a volume of the paper: a file whose name begins so, or a built-in volume.
struct Stand {
  const char *id, *builtin;
  double threshold;
  const char* file = "";
  double file_threshold = 0;
};
constexpr Stand stands[] = {{"harmonic", "gyroid?n=32", 0.6},
                            {"function", "marschner-lobb?n=64", 0.5},
                            {"hydrogen", "noise?n=96", 0.6, "hydrogen", 0.06},
                            {"head", "sphere?n=96", 0.5, "mni152", 0.2},
                            {"engine", "plume?n=96", 0.4, "engine", 0.3},
                            {"bonsai", "vessels?n=96", 0.3, "bonsai", 0.15}};

std::filesystem::path find_file(const std::filesystem::path& folder, const std::string& beginning) {
  if (folder.empty() || beginning.empty()) return {};
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename().string().starts_with(beginning))
      found.push_back(entry.path());
  return found.empty() ? std::filesystem::path() : std::ranges::min(found);
}

}  // namespace

VdlsScene surface_scene(std::string id, std::string title, std::shared_ptr<const Volume> volume,
                        double threshold) {
  const ValueRange field = volume->statistics.range;
  const auto at = [&](double share) { return field.min + share * field.width(); };
  Preset preset;
  const double soft = 0.04;
  preset.transfer_function.unit = LengthUnit::voxel;
  preset.transfer_function.points = {
      point(at(0), 0, {0.3, 0.5, 0.8}), point(at(threshold), 0, {0.3, 0.5, 0.8}),
      point(at(threshold + soft), 0.6, {0.9, 0.7, 0.4}), point(at(1), 0.95, {1, 0.95, 0.8})};
  preset.rendering.mode = Mode::dvr_only;
  preset.rendering.step = 1;
  preset.rendering.shading = Shading::gradient;
  return {std::move(id), std::move(title), make_scene(std::move(volume), preset)};
}

VdlsScene builtin_surface_scene(const std::string& query) {
  return surface_scene(query, "builtin:" + query, std::make_shared<const Volume>(make_builtin(query)), 0.6);
}

std::vector<VdlsScene> vdls_scenes(const std::filesystem::path& folder) {
  if (!folder.empty() && !std::filesystem::is_directory(folder))
    throw Error(folder.string() +
                ": is not a folder: this study takes one with files whose names begin with "
                "hydrogen, mni152 (a head), engine or bonsai");
  std::vector<VdlsScene> scenes;
  for (const Stand& stand : stands) {
    const auto file = find_file(folder, stand.file);
    const std::string title =
        file.empty() ? std::string("builtin:") + stand.builtin : file.filename().string();
    const auto volume = std::make_shared<const Volume>(load_volume(file.empty() ? title : file.string()));
    scenes.push_back(
        surface_scene(stand.id, title, volume, file.empty() ? stand.threshold : stand.file_threshold));
  }
  return scenes;
}

TransferFunction opaque_range(ValueRange field, double from, double to) {
  const auto at = [&](double share) { return field.min + share * field.width(); };
  const glm::dvec3 color(0.9, 0.75, 0.5);
  TransferFunction tf;
  tf.points = {point(at(from), 0, color), point(at(from), 0.9, color), point(at(to), 0.9, color),
               point(at(to), 0, color)};
  return tf;
}

TransferFunction grey_ramp(ValueRange field) {
  TransferFunction tf;
  tf.points = {point(field.min, 0, glm::dvec3(0)), point(field.max, 1, glm::dvec3(1))};
  return tf;
}

VdlsScene phantom_scene() {
  const auto volume = std::make_shared<const Volume>(make_builtin("sphere?n=64"));
  VdlsScene phantom = surface_scene("phantom", "builtin:sphere?n=64", volume, 0.5);
  const ValueRange field = volume->statistics.range;
  const auto at = [&](double share) { return field.min + share * field.width(); };
  phantom.scene.tf.points = {point(at(0), 0, {0.2, 0.3, 0.9}),
                             point(at(0.45), 0.002, {0.2, 0.3, 0.9}),
                             point(at(0.5), 0.15, {0.9, 0.8, 0.3}),
                             point(at(0.55), 0.004, {0.9, 0.4, 0.2}),
                             point(at(0.75), 0.004, {0.9, 0.4, 0.2}),
                             point(at(0.8), 0.5, {1, 0.2, 0.1}),
                             point(at(1), 0.02, {1, 1, 1})};
  phantom.scene.rendering.shading = Shading::none;
  return phantom;
}

std::vector<Camera> random_views(const Grid& grid, int count, std::uint64_t seed) {
  Random random(seed);
  Camera view;
  view.target = grid.origin + 0.5 * grid.box_size();
  view.up = {0, 0, 1};
  // The sphere around the box fills the view's height
  const double distance =
      0.5 * glm::length(grid.box_size()) / std::sin(glm::radians(0.5 * view.fov_y_degrees));
  std::vector<Camera> views;
  for (int i = 0; i < count; ++i) {
    const double z = random.uniform(-1, 1), turn = random.uniform(0, 2 * std::numbers::pi);
    const double radius = std::sqrt(1 - z * z);
    view.eye = view.target + distance * glm::dvec3(radius * std::cos(turn), radius * std::sin(turn), z);
    views.push_back(view);
  }
  return views;
}

}  // namespace crest
