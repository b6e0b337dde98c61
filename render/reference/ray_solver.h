#pragma once

#include <cstdint>
#include <limits>

#include "render/reference/levels.h"
#include "render/reference/polynomial.h"
#include "render/reference/ramp.h"
#include "render/reference/value.h"

namespace crest::reference {

/// The field along a piece of a ray.
template <class Real, int N>
struct FieldPiece {
  Real offset = 0;          ///< the field is this plus `f`
  Polynomial<Real, N> f;    ///< of a place in [0, 1]
  Real length = 0;          ///< in the ray's units
  Real rounding = 0;        ///< of f's values: those nearer to each other count as equal
  Real float_rounding = 0;  ///< of the field, where positions and values are rounded to 32-bit float
};

/// What a ray collects: premultiplied colour and opacity, front to back.
template <class Real>
struct Collected {
  Vec3<Real> color{0};
  Real alpha = 0;
  std::uint32_t crossings = 0;
  bool grazing = false;
};

/// Solves the volume rendering integral and the crossings along one ray, piece by piece from its front.
///
/// A piece is cut at the field's extrema; each run between two knots is monotone and meets the TF's levels in
/// order. Knots within rounding of a level are on it, so that a root on a cell's face or a tangent is decided
/// as in exact arithmetic. A surface of value v is crossed where inside = {f >= v} changes between two runs,
/// or within one; a run that stays on v is inside.
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
  /// A piece whose values all lie in one constant stretch, likewise without surfaces.
  void add_constant(const Stretch<Real>& stretch, Real length);
  void end_span();

  /// Nothing behind shows: less than 1e-17 comes through. (Crossings behind are still counted.)
  bool is_opaque() const { return transmittance_ < Real(1e-17); }
  const Collected<Real>& collected() const { return collected_; }

 private:
  enum class Trend { unknown, falling, flat, rising };

  template <int N>
  void add_run(const FieldPiece<Real, N>& piece, Real from, Real to, Value<Real> first, Value<Real> last);
  template <int N>
  void integrate_run(const FieldPiece<Real, N>& piece, Real from, Real to, Value<Real> first,
                     Value<Real> last);
  template <int N>
  void composite_ramp(const Stretch<Real>& stretch, Real fraction, const Polynomial<Real, N>& risen,
                      Real length);
  template <int N>
  void composite_panel(const Ramp<Real, N>& ramp, const Stretch<Real>& stretch, Vec3<Real> color, Real z0,
                       Real z1, int halvings);
  void composite_flat(Value<Real> value, Real length);
  void composite(Vec3<Real> color, Real depth);
  void cross(const Level<Real>& level, bool rising);
  void enter_run(Value<Real> value, Trend trend, Real float_rounding);
  void note_grazing(Value<Real> value, Real float_rounding);
  Value<Real> snapped(Value<Real> value, Real rounding) const;

  const Levels<Real>& levels_;
  Real tolerance_;
  Real transmittance_ = 1;
  Collected<Real> collected_;

  Trend trend_ = Trend::unknown;  ///< of the last run that counts
  bool knot_known_ = false;
  Value<Real> knot_;  ///< the field's value where the last piece ended
  Real knot_float_rounding_ = 0;
};

}  // namespace crest::reference
