#include "render/reference/scene_levels.h"

#include <algorithm>

#include "render/volume/empty_cells.h"

namespace crest::reference {

template <class Real>
Levels<Real> levels_of(const Scene& scene, Answer answer, std::span<const Peak> surfaces) {
  TransferFunction tf = scene.tf;
  if (answer == Answer::crossings) tf.points.clear();
  if (answer == Answer::base_and_crossings) tf = base_transfer_function(tf, find_peaks(tf));
  if (answer == Answer::integral) surfaces = {};
  return make_levels<Real>(std::move(tf), surfaces, scene.volume->grid.smallest_spacing());
}

template <class Real>
FieldLevels<Real> levels_apart(const Scene& scene, Answer answer, std::span<const Peak> surfaces) {
  FieldLevels<Real> levels;
  levels.are_apart = true;
  levels.levels = levels_of<Real>(scene, answer, std::span<const Peak>());
  if (answer == Answer::integral) surfaces = {};
  levels.surfaces = levels_of<Real>(scene, Answer::crossings, surfaces);
  return levels;
}

VolumeFields fields_of(const Scene& scene, Answer answer) {
  const auto [dvr, root] = filters_of(answer, scene.rendering);
  VolumeFields fields{*scene.volume, dvr, root, {}};
  if (scene.volume->has_empty_cells())
    fields.empty_cells = find_empty_cells(*scene.volume, std::max(radius_of(dvr), radius_of(root)));
  return fields;
}

template Levels<double> levels_of(const Scene&, Answer, std::span<const Peak>);
template Levels<float> levels_of(const Scene&, Answer, std::span<const Peak>);
template FieldLevels<double> levels_apart(const Scene&, Answer, std::span<const Peak>);
template FieldLevels<float> levels_apart(const Scene&, Answer, std::span<const Peak>);

}  // namespace crest::reference
