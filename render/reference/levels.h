#pragma once

#include <span>
#include <vector>

#include "presets/peaks.h"
#include "presets/transfer_function.h"
#include "render/reference/value.h"

namespace crest::reference {

/// The TF between two successive levels: linear in colour and in opacity, which does not pass the cap.
template <class Real>
struct LinearPiece {
  Real width = 0;  ///< of its values; 0 beyond the TF's ends, where it is constant
  Real opacity_low = 0, opacity_high = 0;
  Vec3<Real> color_low{0}, color_high{0};
  bool is_clear = true;  ///< nothing is absorbed
  bool is_constant = true;
};

/// A shown peak, as something that a ray crosses.
template <class Real>
struct CrossedSurface {
  Real value, opacity;
  Vec3<Real> color;
};

/// A value at which the TF may bend, or that a surface has.
template <class Real>
struct Level {
  Value<Real> value;
  Vec3<Real> color{0};
  Real opacity = 0;                                 ///< where the field stays at the value
  std::size_t first_surface = 0, past_surface = 0;  ///< the surfaces of this value
};

/// A TF cut at its control points, at the opacity cap, and at the surfaces' values: what a ray meets as the
/// field rises or falls along it.
///
///   piece 0 | level 0 | piece 1 | level 1 | ... | level n-1 | piece n        by ascending value
///
/// Opacity is linear in a linear, and min(a, 1 - 2^-24) is, too, since the cap a = 1 - 2^-24 is a level.
template <class Real>
struct Levels {
  std::vector<Level<Real>> levels;
  std::vector<LinearPiece<Real>> pieces;
  std::vector<CrossedSurface<Real>> surfaces;  ///< by ascending value
  Real extinction_scale = 1;  ///< -log(1 - opacity) times this is the extinction per unit of length

  /// The piece that holds a value: the upper one at a level.
  std::size_t piece_at(Value<Real> value) const;
  /// Whether a surface's value lies in [low, high].
  bool surface_within(Real low, Real high) const;
  /// Whether something in [low, high] absorbs.
  bool visible_within(Real low, Real high) const;
  /// The constant piece that holds all of [low, high], if there is one.
  const LinearPiece<Real>* constant_within(Real low, Real high) const;

  /// For pieces and levels in turn (2i, 2i + 1): the next one that is not clear.
  std::vector<std::size_t> next_visible;
};

/// `tf` is resolved, `unit_length` is what lengths along the ray are measured in, in world units. The values
/// are first rounded to Real. `cuts` are further levels, at which nothing changes.
template <class Real>
Levels<Real> make_levels(TransferFunction tf, std::span<const Peak> surfaces, double unit_length,
                         std::span<const double> cuts = {});

}  // namespace crest::reference
