#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "render/reference/field_piece.h"
#include "render/reference/levels.h"
#include "render/reference/ramp.h"

namespace crest::reference {

/// What a ray collects: premultiplied colour and opacity, front to back.
template <class Real>
struct Collected {
  Vec3<Real> color{0};
  Real alpha = 0;
  std::uint32_t crossings = 0;
  bool grazing = false;
};

/// A surface that is crossed in a piece, at a place of it in [0, 1].
template <class Real>
struct MetSurface {
  Real place = 0;
  const CrossedSurface<Real>* surface = nullptr;
};

/// What of a ray's opacity comes from where: their sum is its alpha.
template <class Real>
struct Shares {
  std::vector<Real> of_piece;  ///< of Levels::pieces
  struct OfSurface {
    Real value, alpha;
  };
  std::vector<OfSurface> of_surfaces;  ///< as they were crossed
};

/// Solves the volume rendering integral and the crossings along one ray, piece by piece from its front:
///
///   C = sum over monotone parts of T_0 * integral of c(f) rho(f) T ds,   T = exp(-integral of rho(f) ds),
///   and at each crossing of a surface   C += T c_k a_k,   T *= 1 - a_k.
///
/// A piece is cut at the field's extrema (f' = 0); each part between two such knots is monotone, and meets
/// the TF's levels in order. What lies between two levels is a ramp (ramp.h), or constant, where the integral
/// is c (1 - exp(-rho ds)). Knots within rounding of a level are on it, so that a root on a cell's face or a
/// tangent is decided as in exact arithmetic. A surface of value v is crossed where inside = {f >= v} changes
/// between two parts, or within one; a part that stays on v is inside.
template <class Real>
class RaySolver {
 public:
  /// `tolerance` is absolute, for each channel.
  RaySolver(const Levels<Real>& levels, double tolerance);

  /// Nothing before counts as a neighbour: the box or an empty cell lies between.
  void begin_span();
  template <int N>
  void add(const FieldPiece<Real, N>& piece);
  /// A piece in which nothing absorbs, and no surface's value is within rounding of the field's.
  void add_clear();
  /// A piece whose values all lie in one constant piece of the TF, likewise without surfaces.
  void add_constant(const LinearPiece<Real>& linear, Real length);
  void end_span();

  /// From now on the surfaces that a piece meets are added to `met`, in order, and not composited.
  void tell_surfaces(std::vector<MetSurface<Real>>& met) { met_ = &met; }
  void composite_surface(const CrossedSurface<Real>& surface);
  /// From now on what is collected is also added to `shares`, whose `of_piece` has an entry for each.
  void tell_shares(Shares<Real>& shares) { shares_ = &shares; }
  void note_grazing() { collected_.grazing = true; }

  /// Nothing behind shows: less than 1e-17 comes through.
  bool is_opaque() const { return transmittance_ < Real(1e-17); }
  /// Nothing behind shows, and there are no crossings to be counted.
  bool is_finished() const { return is_opaque() && levels_.surfaces.empty(); }
  const Levels<Real>& levels() const { return levels_; }
  const Collected<Real>& collected() const { return collected_; }

 private:
  enum class Trend { unknown, falling, flat, rising };

  template <int N>
  void add_monotone(const FieldPiece<Real, N>& piece, Real from, Real to, Value<Real> first,
                    Value<Real> last);
  template <int N>
  void integrate_monotone(const FieldPiece<Real, N>& piece, Real from, Real to, Value<Real> first,
                          Value<Real> last);
  template <int N>
  Real composite_linear(const FieldPiece<Real, N>& piece, std::size_t index, Real from, Real to,
                        Value<Real> value, Value<Real> end, bool ends_at_level);
  template <int N>
  void composite_ramp(const LinearPiece<Real>& linear, Real fraction, const Polynomial<Real, N>& risen,
                      Real length);
  template <int N>
  void composite_panel(const Ramp<Real, N>& ramp, const LinearPiece<Real>& linear, Vec3<Real> color, Real z0,
                       Real z1, int halvings);
  void composite_flat(Value<Real> value, Real length);
  void composite(const LinearPiece<Real>& linear, Vec3<Real> color, Real depth);
  void collect(const LinearPiece<Real>& linear, Vec3<Real> light, Real absorbed);
  void cross(const Level<Real>& level, bool rising, Real place);
  void enter_monotone(Value<Real> value, Trend trend, Real place, Real float_rounding);
  void note_grazing(Value<Real> value, Real float_rounding);
  Value<Real> snapped(Value<Real> value, Real rounding) const;

  const Levels<Real>& levels_;
  Real tolerance_;
  Real transmittance_ = 1;
  Collected<Real> collected_;
  std::vector<MetSurface<Real>>* met_ = nullptr;  ///< where they are only told
  Shares<Real>* shares_ = nullptr;

  Trend trend_ = Trend::unknown;  ///< of the last monotone part that counts
  bool knot_known_ = false;
  Value<Real> knot_;  ///< the field's value where the last piece ended
  Real knot_float_rounding_ = 0;
};

}  // namespace crest::reference
