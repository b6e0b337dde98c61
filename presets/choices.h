#pragma once

#include "presets/preset.h"

namespace crest {

// What the values of a preset's settings mean, where more than one place asks for it. Each function is a
// switch over all values without a default, so that a new value does not compile before somebody has decided
// on it.

/// Whether a ray collects samples of the volume.
constexpr bool shows_dvr(Mode mode) {
  switch (mode) {
    case Mode::both:
    case Mode::peak_xor_dvr:
    case Mode::dvr_only:
      return true;
    case Mode::peak_only:
      break;
  }
  return false;
}

/// Whether a ray collects the surfaces at the peaks.
constexpr bool shows_surfaces(Mode mode) {
  switch (mode) {
    case Mode::both:
    case Mode::peak_xor_dvr:
    case Mode::peak_only:
      return true;
    case Mode::dvr_only:
      break;
  }
  return false;
}

/// Whether a surface takes the place of the samples at its peak.
constexpr bool is_exclusive(Mode mode) {
  switch (mode) {
    case Mode::peak_xor_dvr:
      return true;
    case Mode::both:
    case Mode::peak_only:
    case Mode::dvr_only:
      break;
  }
  return false;
}

/// Whether a step is divided at its crossings.
constexpr bool is_split(PeakForm form) {
  switch (form) {
    case PeakForm::split:
      return true;
    case PeakForm::paper:
      break;
  }
  return false;
}

/// Whether an engine knows this mode.
constexpr bool renders(Engine engine, Mode mode) {
  switch (engine) {
    case Engine::raycaster:
    case Engine::reference:
      return true;
    case Engine::vdls:
      break;
  }
  return !shows_surfaces(mode);
}

/// The settings in another mode, with the ray caster where their own engine does not render it.
inline Rendering in_mode(Rendering rendering, Mode mode) {
  rendering.mode = mode;
  if (!renders(rendering.engine, mode)) rendering.engine = Engine::raycaster;
  return rendering;
}

/// Whether a step's colour and opacity follow from the field at both of its ends, not from a sample.
constexpr bool is_preintegrated(ClassificationMethod method) {
  switch (method) {
    case ClassificationMethod::preintegrated:
    case ClassificationMethod::preintegrated_table:
      return true;
    case ClassificationMethod::post:
    case ClassificationMethod::analytic:
      break;
  }
  return false;
}

/// Whether rays are solved from cell to cell, without steps.
constexpr bool is_analytic(ClassificationMethod method) {
  switch (method) {
    case ClassificationMethod::analytic:
      return true;
    case ClassificationMethod::post:
    case ClassificationMethod::preintegrated:
    case ClassificationMethod::preintegrated_table:
      break;
  }
  return false;
}

/// Whether the field between the grid's points is trilinear: a cubic along a ray, in each cell.
constexpr bool is_trilinear(Filter filter) {
  switch (filter) {
    case Filter::linear:
    case Filter::linear_exact:
      return true;
    case Filter::bspline:
    case Filter::bc:
      break;
  }
  return false;
}

/// Whether a ray is divided at its crossings, whichever way it is solved.
constexpr bool is_divided(const Rendering& rendering) {
  return is_split(rendering.peak_form) || is_analytic(rendering.classification);
}

/// Whether the base TF stands for the samples: the TF without the spikes that are shown as surfaces.
constexpr bool takes_base_tf(const Rendering& rendering) {
  return is_exclusive(rendering.mode) && is_divided(rendering);
}

/// Whether all steps must have the length that its table was made for.
constexpr bool holds_one_length(ClassificationMethod method) {
  switch (method) {
    case ClassificationMethod::preintegrated_table:
      return true;
    case ClassificationMethod::post:
    case ClassificationMethod::preintegrated:
    case ClassificationMethod::analytic:
      break;
  }
  return false;
}

/// Whether steps are all of `rendering.step`, and placed; otherwise `rendering.s_k` tells their lengths.
constexpr bool has_equal_steps(Sampling sampling) {
  switch (sampling) {
    case Sampling::uniform:
      return true;
    case Sampling::differential:
    case Sampling::footprint:
      break;
  }
  return false;
}

/// Whether light depends on the field's gradient.
constexpr bool takes_gradient(Shading shading) {
  switch (shading) {
    case Shading::gradient:
      return true;
    case Shading::none:
      break;
  }
  return false;
}

}  // namespace crest
