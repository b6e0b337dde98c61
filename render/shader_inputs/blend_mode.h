#pragma once

#include <epoxy/gl.h>

#include "render/classify/stored_units.h"
#include "render/scene/scene.h"

namespace crest {

/// Whether a filter shows values alone: it has no use for the TF, for shading, nor for skipping what the TF
/// makes transparent.
inline bool shows_values(BlendMode blend_mode) {
  switch (blend_mode) {
    case BlendMode::maximum:
    case BlendMode::minimum:
    case BlendMode::mean:
      return true;
    case BlendMode::semi_transparent:
    case BlendMode::lookup:
    case BlendMode::iso_surface:
      break;
  }
  return false;
}

/// The opacity from which on iso_surface takes a value for inside: half the TF's greatest in the field's
/// range.
double iso_opacity(const TransferFunction& tf, ValueRange field);

/// What blend_mode.glsl asks of a program.
void bind_blend_mode(GLuint program, const Scene& scene, const StoredUnits& units);

/// How what is drawn joins what is there: from further back, or from nearer where `back_to_front`; or by the
/// filter's own sum, maximum or minimum. Does not enable blending.
void set_blending(BlendMode blend_mode, bool back_to_front);

}  // namespace crest
