#include "render/reference/solved_scene.h"

#include <algorithm>
#include <utility>

#include "render/classify/classification.h"
#include "render/volume/empty_cells.h"

namespace crest::reference {
namespace {

/// The fields of the filters that the answer shows.
VolumeFields fields_of(const Scene& scene, Answer answer, std::shared_ptr<const EmptyCells> known) {
  const auto [dvr, root] = filters_of(answer, scene.rendering);
  VolumeFields fields{*scene.volume, dvr, root, {}};
  if (!scene.volume->has_empty_cells()) return fields;
  const int radius = std::max(radius_of(dvr), radius_of(root));
  if (!known || known->volume != scene.volume.get() || known->radius != radius)
    known = std::make_shared<const EmptyCells>(
        EmptyCells{scene.volume.get(), radius, find_empty_cells(*scene.volume, radius)});
  fields.empty_cells = std::move(known);
  return fields;
}

}  // namespace

template <class Real>
Levels<Real> levels_of(const Scene& scene, Answer answer, std::span<const Peak> surfaces,
                       std::span<const double> cuts) {
  TransferFunction tf = scene.tf;
  if (answer == Answer::crossings) tf.points.clear();
  if (answer == Answer::base_and_crossings) tf = base_transfer_function(tf, find_peaks(tf));
  if (answer == Answer::integral) surfaces = {};
  return make_levels<Real>(std::move(tf), surfaces, scene.volume->grid.smallest_spacing(), cuts);
}

template <class Real>
SolvedScene<Real> solved_scene(const Scene& scene, Answer answer, std::span<const double> cuts, bool apart,
                               std::shared_ptr<const EmptyCells> known) {
  SolvedScene<Real> solved{fields_of(scene, answer, std::move(known)), {}};
  FieldLevels<Real>& levels = solved.levels;
  std::vector<Peak> surfaces;
  if (answer != Answer::integral) surfaces = classify(scene.tf, surface_range(scene)).surfaces;
  levels.are_apart = apart || (solved.fields.dvr != solved.fields.root && !surfaces.empty());
  levels.levels = levels_of<Real>(scene, answer, levels.are_apart ? std::span<const Peak>() : surfaces, cuts);
  if (levels.are_apart) levels.surfaces = levels_of<Real>(scene, Answer::crossings, surfaces);
  return solved;
}

template Levels<double> levels_of(const Scene&, Answer, std::span<const Peak>, std::span<const double>);
template Levels<float> levels_of(const Scene&, Answer, std::span<const Peak>, std::span<const double>);
template SolvedScene<double> solved_scene(const Scene&, Answer, std::span<const double>, bool,
                                          std::shared_ptr<const EmptyCells>);
template SolvedScene<float> solved_scene(const Scene&, Answer, std::span<const double>, bool,
                                         std::shared_ptr<const EmptyCells>);

}  // namespace crest::reference
