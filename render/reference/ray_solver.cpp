#include "render/reference/ray_solver.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace crest::reference {
namespace {

/// Monotone parts that stay on a value are inside its surface if they are this long, in smallest spacings:
/// beside a tangent, rounding makes shorter ones.
constexpr double least_flat_length = 1e-6;

/// Optical depths that one panel of the quadrature may have.
constexpr double thickest_panel = 8;

/// Nodes of the two rules that are compared. The error of the finer one is about the square of their
/// difference; like QUADPACK, its power 3/2 is taken for it.
constexpr int coarse_nodes = 5, fine_nodes = 10;
double estimated_error(double difference) { return difference * std::sqrt(difference); }
constexpr double relative_tolerance = 1e-9;  ///< of a panel's own light: narrow spikes are exact too

constexpr int most_halvings = 64;

/// Whether the last bit of a monotone part is better measured by the value that the field has there than by
/// the rounded place: it is short, and the field steep. What a narrow linear piece lacks before a cell's face
/// is then what it has behind it.
template <class Real, int N>
bool ends_steeply(const Polynomial<Real, N>& risen, Real size, Real target, Real rounding) {
  return size < Real(1e-3) && std::abs(risen.derivative()(size) * size) > std::abs(target) / 4 &&
         std::abs(risen(size) - target) <= 4 * rounding;
}

}  // namespace

template <class Real>
RaySolver<Real>::RaySolver(const Levels<Real>& levels, double tolerance)
    : levels_(levels),
      // A ray has some hundred panels that matter, and none is better than rounding.
      tolerance_(std::max(Real(0.01 * tolerance), std::numeric_limits<Real>::epsilon())) {}

template <class Real>
void RaySolver<Real>::begin_span() {
  knot_known_ = false;
  trend_ = Trend::unknown;
}

template <class Real>
void RaySolver<Real>::end_span() {
  if (knot_known_) note_grazing(knot_, knot_float_rounding_);
}

template <class Real>
void RaySolver<Real>::add_clear() {
  begin_span();
}

template <class Real>
void RaySolver<Real>::add_constant(const LinearPiece<Real>& linear, Real length) {
  begin_span();
  composite(linear, linear.color_low, -std::log1p(-linear.opacity_low) * levels_.extinction_scale * length);
}

template <class Real>
Value<Real> RaySolver<Real>::snapped(Value<Real> value, Real rounding) const {
  const std::size_t above = levels_.piece_at(value);
  Value<Real> nearest = value;
  for (std::size_t i = above > 0 ? above - 1 : 0; i < std::min(above + 1, levels_.levels.size()); ++i)
    if (const Real distance = std::abs(levels_.levels[i].value - value); distance <= rounding) {
      rounding = distance;
      nearest = levels_.levels[i].value;
    }
  return nearest;
}

template <class Real>
template <int N>
void RaySolver<Real>::add(const FieldPiece<Real, N>& piece) {
  const auto value_at = [&](Real place) {
    return snapped(exact_sum(piece.offset, piece.f(place)), piece.rounding);
  };
  Real from = 0;
  Value<Real> first = knot_known_ ? knot_ : value_at(0);
  const Value<Real> last = value_at(1);
  const auto extrema = sign_changes(piece.f.derivative());
  for (int i = 0; i < extrema.count; ++i) {
    const Real place = extrema.at[std::size_t(i)];
    const Value<Real> value = value_at(place);
    const Value<Real> next = i + 1 < extrema.count ? value_at(extrema.at[std::size_t(i + 1)]) : last;
    if (std::abs(value - first) <= piece.rounding || std::abs(next - value) <= piece.rounding) continue;
    add_monotone(piece, from, place, first, value);
    from = place;
    first = value;
  }
  add_monotone(piece, from, Real(1), first, last);
  knot_ = last;
  knot_known_ = true;
  knot_float_rounding_ = piece.float_rounding;
}

/// The crossing at the knot between two monotone parts, if there is one.
template <class Real>
void RaySolver<Real>::enter_monotone(Value<Real> value, Trend trend, Real place, Real float_rounding) {
  if (trend != trend_ || trend == Trend::flat) note_grazing(value, float_rounding);
  const bool outside_before = trend_ == Trend::rising,
             inside_before = trend_ == Trend::falling || trend_ == Trend::flat;
  if (trend == Trend::falling ? inside_before : outside_before) {
    const std::size_t above = levels_.piece_at(value);
    if (above > 0 && levels_.levels[above - 1].value - value == 0)
      cross(levels_.levels[above - 1], trend != Trend::falling, place);
  }
  trend_ = trend;
}

template <class Real>
template <int N>
void RaySolver<Real>::add_monotone(const FieldPiece<Real, N>& piece, Real from, Real to, Value<Real> first,
                                   Value<Real> last) {
  const Real rise = last - first;
  if (std::abs(rise) <= piece.rounding) {
    const Real length = (to - from) * piece.length;
    if (length > Real(least_flat_length)) enter_monotone(first, Trend::flat, from, piece.float_rounding);
    composite_flat(first, length);
    return;
  }
  enter_monotone(first, rise > 0 ? Trend::rising : Trend::falling, from, piece.float_rounding);
  integrate_monotone(piece, from, to, first, last);
}

template <class Real>
template <int N>
void RaySolver<Real>::integrate_monotone(const FieldPiece<Real, N>& piece, Real from, Real to,
                                         Value<Real> first, Value<Real> last) {
  const bool rising = last - first > 0;
  const auto lies_before = [&](Value<Real> a, Value<Real> b) { return rising ? b - a > 0 : a - b > 0; };
  const auto& levels = levels_.levels;
  std::size_t index = levels_.piece_at(first);
  if (!rising && index > 0 && levels[index - 1].value - first == 0)
    --index;  // the linear piece below the level

  Value<Real> value = first;
  for (;;) {
    const bool has_next = rising ? index < levels.size() : index > 0;
    const Level<Real>* next = has_next ? &levels[rising ? index : index - 1] : nullptr;
    if (next && !lies_before(next->value, last)) next = nullptr;
    if (!next && (levels_.pieces[index].is_clear || is_opaque())) return;

    if (!is_opaque())
      from += composite_linear(piece, index, from, to, value, next ? next->value : last, next != nullptr);
    if (!next) return;
    cross(*next, rising, from);
    value = next->value;
    rising ? ++index : --index;
  }
}

/// What of a monotone part lies from `from` on, in which the field goes from `value` to `end` within one
/// linear piece: to a level, or, where the part ends first, to `to`. Returns how far that is.
template <class Real>
template <int N>
Real RaySolver<Real>::composite_linear(const FieldPiece<Real, N>& piece, std::size_t index, Real from,
                                       Real to, Value<Real> value, Value<Real> end, bool ends_at_level) {
  const LinearPiece<Real>& linear = levels_.pieces[index];
  const Real target = end - value;
  const bool rising = target > 0;
  Polynomial<Real, N> risen = piece.f.shifted(from);
  risen.c[0] = 0;  // from here on, without the rounding of the value itself
  Real size = to - from;
  if (ends_at_level || ends_steeply(risen, size, target, piece.rounding))
    size = solve_monotone(risen, target, Real(0), size, rising, target / risen.c[1]);
  if (linear.is_clear) return size;

  const Real length = size * piece.length;
  if (linear.is_constant) {
    composite(linear, linear.color_low, -std::log1p(-linear.opacity_low) * levels_.extinction_scale * length);
    return size;
  }
  Real fraction = rising ? Real(0) : Real(1);
  const Value<Real> level_behind = levels_.levels[rising ? index - 1 : index].value;
  if (value - level_behind != 0) fraction = (value - levels_.levels[index - 1].value) / linear.width;
  composite_ramp(linear, fraction, risen.stretched(size), length);
  return size;
}

template <class Real>
template <int N>
void RaySolver<Real>::composite_ramp(const LinearPiece<Real>& linear, Real fraction,
                                     const Polynomial<Real, N>& risen, Real length) {
  Polynomial<Real, N> rise = risen;
  for (Real& c : rise.c) c /= linear.width;
  const Ramp<Real, N> ramp(linear, fraction, rise, levels_.extinction_scale * length);
  composite_panel(ramp, linear, glm::mix(linear.color_low, linear.color_high, fraction), Real(0), ramp.size,
                  0);
}

template <class Real>
template <int N>
void RaySolver<Real>::composite_panel(const Ramp<Real, N>& ramp, const LinearPiece<Real>& linear,
                                      Vec3<Real> color, Real z0, Real z1, int halvings) {
  if (is_opaque()) return;
  const auto coarse = ramp.template integrate<coarse_nodes>(z0, z1);
  if (!(coarse.depth > Real(thickest_panel)) || halvings == most_halvings) {
    const auto fine = ramp.template integrate<fine_nodes>(z0, z1);
    const Real absorbed = -std::expm1(-fine.depth);
    const double difference =
        double(std::max(std::abs(absorbed + std::expm1(-coarse.depth)), std::abs(fine.risen - coarse.risen)));
    const double error = estimated_error(difference);
    const bool is_good = error * double(transmittance_) <= double(tolerance_) &&
                         difference <= std::sqrt(relative_tolerance) * double(absorbed);
    if (is_good || halvings == most_halvings) {
      const Vec3<Real> light = color * absorbed + (linear.color_high - linear.color_low) * fine.risen;
      collect(linear, light, absorbed);
      transmittance_ *= std::exp(-fine.depth);
      return;
    }
  }
  const Real middle = (z0 + z1) / 2;
  composite_panel(ramp, linear, color, z0, middle, halvings + 1);
  composite_panel(ramp, linear, color, middle, z1, halvings + 1);
}

template <class Real>
void RaySolver<Real>::composite_flat(Value<Real> value, Real length) {
  if (is_opaque()) return;
  const std::size_t index = levels_.piece_at(value);
  const LinearPiece<Real>& linear = levels_.pieces[index];
  Vec3<Real> color = linear.color_low;
  Real opacity = linear.opacity_low;
  if (index > 0 && levels_.levels[index - 1].value - value == 0) {
    color = levels_.levels[index - 1].color;
    opacity = levels_.levels[index - 1].opacity;
  } else if (!linear.is_constant) {
    const Real fraction = (value - levels_.levels[index - 1].value) / linear.width;
    color = glm::mix(linear.color_low, linear.color_high, fraction);
    opacity = linear.opacity_low + (linear.opacity_high - linear.opacity_low) * fraction;
  }
  composite(linear, color, -std::log1p(-opacity) * levels_.extinction_scale * length);
}

template <class Real>
void RaySolver<Real>::composite(const LinearPiece<Real>& linear, Vec3<Real> color, Real depth) {
  const Real absorbed = -std::expm1(-depth);
  collect(linear, absorbed * color, absorbed);
  transmittance_ *= std::exp(-depth);
}

template <class Real>
void RaySolver<Real>::collect(const LinearPiece<Real>& linear, Vec3<Real> light, Real absorbed) {
  collected_.color += transmittance_ * light;
  collected_.alpha += transmittance_ * absorbed;
  if (shares_) shares_->of_piece[std::size_t(&linear - levels_.pieces.data())] += transmittance_ * absorbed;
}

template <class Real>
void RaySolver<Real>::cross(const Level<Real>& level, bool rising, Real place) {
  for (std::size_t i = level.first_surface; i < level.past_surface; ++i) {
    const auto& surface = levels_.surfaces[rising ? i : level.past_surface - 1 - (i - level.first_surface)];
    if (met_)
      met_->push_back({place, &surface});
    else
      composite_surface(surface);
  }
}

template <class Real>
void RaySolver<Real>::composite_surface(const CrossedSurface<Real>& surface) {
  collected_.color += transmittance_ * surface.opacity * surface.color;
  collected_.alpha += transmittance_ * surface.opacity;
  if (shares_) shares_->of_surfaces.push_back({surface.value, transmittance_ * surface.opacity});
  transmittance_ *= 1 - surface.opacity;
  ++collected_.crossings;
}

template <class Real>
void RaySolver<Real>::note_grazing(Value<Real> value, Real float_rounding) {
  collected_.grazing =
      collected_.grazing || levels_.surface_within(value.hi - float_rounding, value.hi + float_rounding);
}

template class RaySolver<double>;
template class RaySolver<float>;
template void RaySolver<double>::add<cell_degree>(const FieldPiece<double, cell_degree>&);
template void RaySolver<float>::add<cell_degree>(const FieldPiece<float, cell_degree>&);
template void RaySolver<double>::add<cubic_cell_degree>(const FieldPiece<double, cubic_cell_degree>&);
template void RaySolver<float>::add<cubic_cell_degree>(const FieldPiece<float, cubic_cell_degree>&);
template void RaySolver<double>::add<formula_degree>(const FieldPiece<double, formula_degree>&);

}  // namespace crest::reference
