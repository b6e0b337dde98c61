#pragma once

#include <span>

#include "render/reference/answer.h"
#include "render/reference/levels.h"
#include "render/reference/volume_field.h"
#include "render/scene/scene.h"

namespace crest::reference {

/// What an answer integrates, and which of the surfaces it shows.
template <class Real>
Levels<Real> levels_of(const Scene& scene, Answer answer, std::span<const Peak> surfaces);

/// The same apart: what is integrated, and the surfaces that the answer shows.
template <class Real>
FieldLevels<Real> levels_apart(const Scene& scene, Answer answer, std::span<const Peak> surfaces);

/// The fields of the filters that the answer shows. They refer to the scene's volume.
VolumeFields fields_of(const Scene& scene, Answer answer);

}  // namespace crest::reference
