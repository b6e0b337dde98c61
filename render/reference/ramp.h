#pragma once

#include <algorithm>
#include <cmath>

#include "render/reference/collocation.h"
#include "render/reference/levels.h"
#include "render/reference/polynomial.h"

namespace crest::reference {

/// The integral over a monotone part of a field piece, within one linear piece of the TF. With y in
/// [0, 1] along the part, the place in the linear piece is its `fraction` (0 at the lower level, 1 at the
/// upper)
///
///   p(y) = start + rise(y),   a(y) = a_low + (a_high - a_low) p(y),   depth'(y) = -ln(1 - a(y)) depth_scale,
///
/// and what is wanted is   integral of (1, rise(y)) depth'(y) exp(-depth(y)) dy,   from which the light
/// follows, as colour is linear in p.
///
/// `rise` is a difference from where the part begins, scaled by the linear piece's width: so one as narrow as
/// 1e-12 of the field's range is known as well as a wide one. It is integration over the value
/// (dt = df / f') in another form, which also holds where f' vanishes.
///
/// Where the opacity reaches 1 at an end, -ln(1-a) has a logarithmic singularity there, which the cap cuts
/// off. As tanh-sinh quadrature does, the part then takes an exponential change of variable that moves the
/// end far away: with e the ratio of the transmittances 1-a at the two ends and z in [0, ln(1 + 1/e)],
///
///   y = e (exp(z) - 1), or the mirror image of it.
///
/// (Boost's tanh-sinh itself gives one integral, not the running one that absorption needs.)
template <class Real, int N>
struct Ramp {
  Polynomial<Real, N> rise;  ///< of the fraction, from where the part begins, as a function of y; c[0] is 0
  Real start = 0;            ///< the fraction there
  Real opacity_low = 0, opacity_high = 0;  ///< the linear piece's
  Real depth_scale = 1;                    ///< -log(1-a) times this is the optical depth per y

  enum class Ends { regular, steep_at_start, steep_at_end } ends = Ends::regular;
  Real steepness = 1;  ///< transmittance at the steep end over that at the other
  Real size = 1;       ///< z runs from 0 to this

  Ramp(const LinearPiece<Real>& linear, Real start_fraction, const Polynomial<Real, N>& rise_,
       Real depth_scale_)
      : rise(rise_),
        start(start_fraction),
        opacity_low(linear.opacity_low),
        opacity_high(linear.opacity_high),
        depth_scale(depth_scale_) {
    const Real at_start = 1 - opacity(Real(0)), at_end = 1 - opacity(rise(Real(1)));
    steepness = std::min(at_start, at_end) / std::max(at_start, at_end);
    if (steepness > Real(1) / 16) return;
    ends = at_start < at_end ? Ends::steep_at_start : Ends::steep_at_end;
    size = std::log1p(1 / steepness);
  }

  Real opacity(Real risen) const {
    const Real fraction = std::clamp(start + risen, Real(0), Real(1));
    return opacity_low + (opacity_high - opacity_low) * fraction;
  }

  /// Between two places of it: its optical depth, and its absorbed light where the colour is the fraction's
  /// rise.
  struct Light {
    Real depth = 0, risen = 0;
  };

  template <int Nodes>
  Light integrate(Real z0, Real z1) const {
    const auto& rule = collocation<Real, Nodes>();
    std::array<Real, Nodes> risen, depth;
    for (std::size_t i = 0; i < Nodes; ++i) {
      Real slope = 1;
      const Real y = place(z0 + (z1 - z0) * rule.node[i], slope);
      risen[i] = rise(y);
      depth[i] = -std::log1p(-opacity(risen[i])) * depth_scale * slope * (z1 - z0);
    }
    Light light;
    for (std::size_t i = 0; i < Nodes; ++i) {
      Real before = 0;
      for (std::size_t j = 0; j < Nodes; ++j) before += rule.up_to_node[i][j] * depth[j];
      light.depth += rule.weight[i] * depth[i];
      light.risen += rule.weight[i] * depth[i] * risen[i] * std::exp(-before);
    }
    return light;
  }

  /// y, and dy/dz.
  Real place(Real z, Real& slope) const {
    switch (ends) {
      case Ends::regular:
        return z;
      case Ends::steep_at_start:
        slope = steepness * std::exp(z);
        return steepness * std::expm1(z);
      case Ends::steep_at_end:
        slope = steepness * std::exp(size - z);
        return 1 - steepness * std::expm1(size - z);
    }
    return z;
  }
};

}  // namespace crest::reference
