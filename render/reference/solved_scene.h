#pragma once

#include <span>

#include "render/reference/answer.h"
#include "render/reference/levels.h"
#include "render/reference/volume_field.h"
#include "render/scene/scene.h"

namespace crest::reference {

/// What the answer integrates, and which of the surfaces it shows. `cuts` as make_levels() takes them.
template <class Real>
Levels<Real> levels_of(const Scene& scene, Answer answer, std::span<const Peak> surfaces,
                       std::span<const double> cuts = {});

/// A scene's fields and levels, as solve_volume() takes them. It refers to the scene's volume.
template <class Real>
struct SolvedScene {
  VolumeFields fields;
  FieldLevels<Real> levels;
};
/// `apart`: surfaces are solved on their own also where they lie in the field that is integrated. To find
/// empty cells takes a look at all voxels: `known` are used again where they are this volume's.
template <class Real>
SolvedScene<Real> solved_scene(const Scene& scene, Answer answer, std::span<const double> cuts = {},
                               bool apart = false, std::shared_ptr<const EmptyCells> known = {});

}  // namespace crest::reference
