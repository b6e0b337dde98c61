#include "render/studies/placement/scenes.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "render/scene/camera.h"
#include "render/studies/placement/square.h"
#include "render/studies/stability/scenes.h"
#include "render/volume/builtin.h"

namespace crest {
namespace {

constexpr int tf_points = 33;
constexpr const char* plume = "plume?n=64";

/// Opacity as exp has it, at so many points that straight lines between them are as good.
TransferFunction half_of_value() {
  TransferFunction tf;
  for (int i = 0; i < tf_points; ++i) {
    const double s = double(i) / (tf_points - 1);
    ControlPoint point;
    point.value = s;
    point.opacity = -std::expm1(-s / 2);
    tf.points.push_back(point);
  }
  return tf;
}

PlacementScene dvr_scene(std::string id, std::string title, std::string note, Scene scene,
                         const Camera& camera) {
  scene.rendering.mode = Mode::dvr_only;
  scene.rendering.shading = Shading::none;
  scene.rendering.early_termination = 0;
  return {std::move(id), std::move(title), std::move(note), std::move(scene), camera};
}

Scene default_scene(const char* builtin) {
  Preset preset;
  preset.transfer_function = default_transfer_function();
  return make_scene(std::make_shared<const Volume>(make_builtin(builtin)), preset);
}

}  // namespace

PlacementScene extruded_square() {
  const double half = Square::side / 2;
  const Grid grid{glm::ivec3(Square::points), glm::dvec3(Square::spacing), glm::dvec3(-half)};
  Scene scene{stability::make_volume(grid, [&](glm::dvec3 p) { return (p.x + half) / Square::side; }),
              half_of_value(),
              {}};
  Camera camera;
  camera.eye = {-9 * std::cos(Square::angle), 9 * std::sin(Square::angle), 0};
  camera.target = glm::dvec3(0);
  camera.up = {0, 0, 1};
  return dvr_scene("square", "The linear field in 5 × 5 × 5 points",
                   "The plane study's square, extruded: the paper's figure 4.", std::move(scene), camera);
}

PlacementScene border_scene(const Scene& scene, const Camera& camera) {
  return dvr_scene("border", scene.volume->name, "A volume with data at its border, as the paper's figure 5.",
                   scene, camera);
}

PlacementScene builtin_border_scene(double aspect) {
  const Scene scene = default_scene("gyroid?n=48");
  PlacementScene result = border_scene(scene, whole_volume_camera(scene.volume->grid, aspect));
  result.title = "builtin:gyroid?n=48";
  return result;
}

PlacementScene whole_plume(double aspect) {
  const Scene scene = default_scene(plume);
  return dvr_scene("plume", "builtin:plume?n=64, whole", "Its data end before its border, but for its top.",
                   scene, whole_volume_camera(scene.volume->grid, aspect));
}

PlacementScene clipped_plume(double aspect) {
  PlacementScene result = whole_plume(aspect);
  result.id = "clipped";
  result.title = "builtin:plume?n=64 in a clip box";
  result.note = "The box cuts through the data on two sides.";
  const Grid& grid = result.scene.volume->grid;
  ClipBox box;
  box.min = grid.origin + grid.spacing * glm::dvec3(30, 30, 0);
  box.max = grid.box_max();
  result.scene.rendering.clip_box = box;
  return result;
}

Scene cropped(const Scene& scene) {
  const Volume& whole = *scene.volume;
  const ClipBox& box = *scene.rendering.clip_box;
  const glm::ivec3 first = glm::round((box.min - whole.grid.origin) / whole.grid.spacing),
                   last = glm::round((box.max - whole.grid.origin) / whole.grid.spacing);
  Volume part;
  part.grid = {last - first + 1, whole.grid.spacing,
               whole.grid.origin + whole.grid.spacing * glm::dvec3(first)};
  part.name = whole.name;
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i) part.values.floats().push_back(whole.at(i, j, k));
  part.statistics = compute_statistics(part.grid, part.values);
  Scene result{std::make_shared<const Volume>(std::move(part)), scene.tf, scene.rendering};
  result.rendering.clip_box.reset();
  return result;
}

}  // namespace crest
