#include "render/stability/views.h"

#include <fmt/format.h>

#include <algorithm>

#include "presets/names.h"
#include "render/camera.h"

namespace crest::stability {
namespace {

Image flipped(Image image) {
  for (int y = 0; y < image.size.y; ++y)
    for (int x = 0; x < image.size.x / 2; ++x) std::swap(image.at(x, y), image.at(image.size.x - 1 - x, y));
  return image;
}

/// Pixels whose rays meet more or fewer surfaces when these move by 1e-4 of the field's range.
std::vector<bool> nearly_grazing(const Lab& lab, const View& view) {
  std::vector<unsigned> crossings[2];
  for (const int side : {0, 1}) {
    Scene moved = view.scene;
    const double shift = (side == 0 ? -1e-4 : 1e-4) * view.scene.volume->statistics.range.width();
    for (auto& p : moved.tf.points) p.value += shift;
    crossings[side] = draw_counted(lab, moved, view.camera, lab.size).crossings;
  }
  std::vector<bool> grazing;
  for (std::size_t i = 0; i < crossings[0].size(); ++i) grazing.push_back(crossings[0][i] != crossings[1][i]);
  return grazing;
}

}  // namespace

View plain_view(Mode mode) {
  const VolumePtr volume = gyroid_in_levels();
  return {make_scene(volume, haze_and_peaks(volume->statistics.range, 8 * volume->grid.smallest_spacing()),
                     mode, fine_step),
          whole_volume_camera(volume->grid)};
}

std::vector<Row> rows_of_changes(Lab& lab, const std::string& name, const std::function<View(Mode)>& plain,
                                 const std::vector<Change>& changes) {
  std::vector<Row> rows;
  for (const Mode mode : tested_modes) {
    const View view = plain(mode);
    std::vector<Image> pictures{lab.draw(view.scene, view.camera)};
    const std::vector<bool> grazing = nearly_grazing(lab, view);
    const auto left_out = int(std::ranges::count(grazing, true));
    Worst worst;
    for (const Change& change : changes) {
      const View other = change.apply(view);
      const Image image = lab.draw(other.scene, other.camera);
      pictures.push_back(change.mirrors_picture ? flipped(image) : image);
      worst.take(largest_difference(pictures.front(), pictures.back(), grazing), change.name);
    }
    rows.push_back(judge({.name = fmt::format("{}, {}", name, crest::name_of(mode)),
                          .quantity = "largest difference of a channel between the pictures",
                          .bound = 1e-5,
                          .truth = Truth::invariance},
                         worst, pictures, left_out));
  }
  return rows;
}

View with_values(const View& view, double scale, double shift) {
  View changed = view;
  Volume volume = *view.scene.volume;
  for (float& value : volume.values) value = float(scale * double(value) + shift);
  volume.statistics = compute_statistics(volume.values);
  changed.scene.volume = std::make_shared<const Volume>(std::move(volume));
  auto& points = changed.scene.tf.points;
  for (auto& p : points) p.value = scale * p.value + shift;
  if (scale < 0) std::ranges::reverse(points);
  return changed;
}

}  // namespace crest::stability
