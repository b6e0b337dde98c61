#include "render/studies/stability/views.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/names.h"
#include "render/scene/camera.h"

namespace crest::stability {
namespace {

template <class Pixel>
void flip(std::vector<Pixel>& pixels, int width) {
  for (auto row = pixels.begin(); row != pixels.end(); row += width) std::reverse(row, row + width);
}

CountedPicture draw(const Lab& lab, const View& view, bool mirrored = false) {
  CountedPicture picture = draw_counted(lab, view.scene, view.camera, lab.size);
  if (mirrored) {
    flip(picture.image.pixels, lab.size.x);
    flip(picture.dvr_samples, lab.size.x);
  }
  return picture;
}

}  // namespace

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

View plain_view(Mode mode) {
  const VolumePtr volume = gyroid_in_levels();
  // All of the box from -1 to 1, in a view of its own: how near its rays pass to tangents is a part of the
  // case
  const Camera camera{{2.9297745775126893, -5.2084881378003365, 2.6042440689001682},
                      {0, 0, 0},
                      {0, 0, 1},
                      30,
                      Projection::perspective,
                      {}};
  return {make_scene(volume, haze_and_peaks(volume->statistics.range, 8 * volume->grid.smallest_spacing()),
                     mode, fine_step),
          camera};
}

std::vector<Row> rows_of_changes(Lab& lab, const std::string& name, const std::function<View(Mode)>& plain,
                                 const std::vector<Change>& changes) {
  std::vector<Row> rows;
  for (const Mode mode : tested_modes) {
    const View view = plain(mode);
    const CountedPicture picture = draw(lab, view);
    const std::vector<bool> grazing = nearly_grazing(lab, view);
    std::vector<Image> pictures{picture.image};
    Worst worst;
    long left_out = 0;
    for (const Change& change : changes) {
      CountedPicture other = draw(lab, change.apply(view), change.mirrors_picture);
      std::vector<bool> hanging = grazing;
      for (std::size_t i = 0; i < hanging.size(); ++i)
        if (picture.dvr_samples[i] != other.dvr_samples[i]) hanging[i] = true;
      left_out = std::max(left_out, std::ranges::count(hanging, true));
      worst.take(largest_difference(picture.image, other.image, hanging), change.name);
      pictures.push_back(std::move(other.image));
    }
    rows.push_back(judge({.name = fmt::format("{}, {}", name, crest::name_of(mode)),
                          .quantity = "largest difference of a channel between the pictures",
                          .bound = 1e-5,
                          .truth = Truth::invariance},
                         worst, pictures, int(left_out)));
  }
  return rows;
}

View with_values(const View& view, double scale, double shift) {
  View changed = view;
  Volume volume = *view.scene.volume;
  for (float& value : volume.values.floats()) value = float(scale * double(value) + shift);
  volume.statistics = compute_statistics(volume.grid, volume.values);
  changed.scene.volume = std::make_shared<const Volume>(std::move(volume));
  auto& points = changed.scene.tf.points;
  for (auto& p : points) p.value = scale * p.value + shift;
  if (scale < 0) std::ranges::reverse(points);
  return changed;
}

}  // namespace crest::stability
