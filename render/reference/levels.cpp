#include "render/reference/levels.h"

#include <algorithm>
#include <glm/common.hpp>

namespace crest::reference {
namespace {

constexpr double opacity_cap = 1 - least_transmittance;

template <class Real>
Value<Real> value_of(double v) {
  const Real hi = Real(v);
  return {hi, Real(v - double(hi))};
}

double capped(double opacity) { return std::min(opacity, opacity_cap); }

template <class Real>
LinearPiece<Real> make_linear(double width, Classified low, Classified high) {
  LinearPiece<Real> linear;
  linear.width = Real(width);
  linear.opacity_low = Real(capped(low.opacity));
  linear.opacity_high = Real(capped(high.opacity));
  linear.color_low = low.color;
  linear.color_high = high.color;
  linear.is_clear = linear.opacity_low == 0 && linear.opacity_high == 0;
  linear.is_constant =
      linear.is_clear || (linear.opacity_low == linear.opacity_high && linear.color_low == linear.color_high);
  return linear;
}

/// Adds the linear piece between two values, in two where its opacity passes the cap. There the level is so
/// near to the end of the piece that it is kept as a difference from that.
template <class Real>
void add_linear(Levels<Real>& result, double from, Classified low, double to, Classified high) {
  const double width = to - from;
  if ((low.opacity > opacity_cap) == (high.opacity > opacity_cap)) {
    result.pieces.push_back(make_linear<Real>(width, low, high));
    return;
  }
  const bool rises = high.opacity > opacity_cap;
  const Classified top = rises ? high : low, foot = rises ? low : high;
  const double from_top = (top.opacity - opacity_cap) / (top.opacity - foot.opacity);
  const Classified at_cap{glm::mix(top.color, foot.color, from_top), opacity_cap};
  const double offset = width * from_top, first_width = rises ? width - offset : offset;
  Value<Real> place = exact_sum(Real(rises ? to : from), Real(rises ? -offset : offset));
  result.pieces.push_back(make_linear<Real>(first_width, low, at_cap));
  result.levels.push_back({.value = place, .color = at_cap.color, .opacity = Real(opacity_cap)});
  result.pieces.push_back(make_linear<Real>(width - first_width, at_cap, high));
}

template <class Real>
void find_visible(Levels<Real>& result) {
  const std::size_t count = 2 * result.levels.size() + 1;
  result.next_visible.assign(count + 1, count);
  for (std::size_t i = count; i-- > 0;) {
    const bool is_clear = i % 2 ? result.levels[i / 2].opacity == 0 : result.pieces[i / 2].is_clear;
    result.next_visible[i] = is_clear ? result.next_visible[i + 1] : i;
  }
}

}  // namespace

template <class Real>
std::size_t Levels<Real>::piece_at(Value<Real> value) const {
  const auto above = std::partition_point(levels.begin(), levels.end(),
                                          [&](const Level<Real>& level) { return level.value - value <= 0; });
  return std::size_t(above - levels.begin());
}

template <class Real>
bool Levels<Real>::surface_within(Real low, Real high) const {
  const auto next = std::partition_point(surfaces.begin(), surfaces.end(),
                                         [&](const CrossedSurface<Real>& s) { return s.value < low; });
  return next != surfaces.end() && next->value <= high;
}

template <class Real>
bool Levels<Real>::visible_within(Real low, Real high) const {
  std::size_t first = 2 * piece_at({low, 0});
  if (first > 0 && levels[first / 2 - 1].value - Value<Real>{low, 0} == 0) --first;  // the level itself
  return next_visible[first] <= 2 * piece_at({high, 0});
}

template <class Real>
const LinearPiece<Real>* Levels<Real>::constant_within(Real low, Real high) const {
  const std::size_t index = piece_at({high, 0});
  const bool begins_at_low = index > 0 && levels[index - 1].value - Value<Real>{low, 0} == 0;
  if (!pieces[index].is_constant || index != piece_at({low, 0}) || begins_at_low) return nullptr;
  return &pieces[index];
}

template <class Real>
Levels<Real> make_levels(TransferFunction tf, std::span<const Peak> surfaces, double unit_length,
                         std::span<const double> cuts) {
  Levels<Real> result;
  result.extinction_scale = Real(std::min(unit_length / tf.unit_distance, 1e30));
  for (ControlPoint& point : tf.points) point.value = double(Real(point.value));
  for (const Peak& peak : surfaces)
    result.surfaces.push_back({Real(peak.value), Real(peak.opacity), Vec3<Real>(peak.color)});

  std::vector<double> values;
  for (const ControlPoint& point : tf.points) values.push_back(point.value);
  for (const auto& surface : result.surfaces) values.push_back(double(surface.value));
  for (const double cut : cuts) values.push_back(double(Real(cut)));
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());

  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i == 0) {
      const Classified below = evaluate_left(tf, values[0]);
      result.pieces.push_back(make_linear<Real>(0, below, below));
    }
    const Classified at = evaluate(tf, values[i]);
    Level<Real> level{
        .value = value_of<Real>(values[i]), .color = at.color, .opacity = Real(capped(at.opacity))};
    const auto [first, past] = std::equal_range(
        result.surfaces.begin(), result.surfaces.end(), CrossedSurface<Real>{Real(values[i]), 0, {}},
        [](const auto& a, const auto& b) { return a.value < b.value; });
    level.first_surface = std::size_t(first - result.surfaces.begin());
    level.past_surface = std::size_t(past - result.surfaces.begin());
    result.levels.push_back(level);
    const Classified above = evaluate_right(tf, values[i]);
    if (i + 1 < values.size())
      add_linear(result, values[i], above, values[i + 1], evaluate_left(tf, values[i + 1]));
    else
      result.pieces.push_back(make_linear<Real>(0, above, above));
  }
  if (values.empty()) result.pieces.emplace_back();
  find_visible(result);
  return result;
}

template struct Levels<double>;
template struct Levels<float>;
template Levels<double> make_levels<double>(TransferFunction, std::span<const Peak>, double,
                                            std::span<const double>);
template Levels<float> make_levels<float>(TransferFunction, std::span<const Peak>, double,
                                          std::span<const double>);

}  // namespace crest::reference
