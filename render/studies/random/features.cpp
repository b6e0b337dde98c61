#include <algorithm>
#include <vector>

#include "render/studies/random/kinds.h"

namespace crest {
namespace {

/// Haze, in which features are put at ascending places of the volume's range.
struct Design {
  Dice& dice;
  ValueRange range;
  TransferFunction tf;
  double level = 0;  ///< of opacity, from the last point on

  void add(double place, double opacity) {
    ControlPoint point;
    point.value = range.min + place * range.width();
    point.color = dice.vector(0, 1);
    point.opacity = opacity;
    tf.points.push_back(point);
  }
  bool has_surface() const {
    return std::ranges::any_of(tf.points, [](const auto& p) { return p.surface.mode == SurfaceMode::on; });
  }
  /// The last point is a surface.
  void show(double opacity) { tf.points.back().surface = {SurfaceMode::on, opacity}; }
};

/// Two to four places, in shares of the range, with room of 0.05 to either side. Labels' values are at
/// multiples of 1/4.
std::vector<double> random_places(Dice& dice, bool labels) {
  std::vector<double> places;
  if (labels) {
    const double between = dice.pick({0.0, 0.0, -0.125});
    places = {0.25, 0.5, 0.75};
    dice.shuffle(places);
    places.resize(std::size_t(2 + dice.one_of(2)));
    std::ranges::sort(places);
    for (double& place : places) place += between;
    return places;
  }
  const int count = 2 + dice.one_of(3);
  for (int i = 0; i < count; ++i) places.push_back(0.08 + 0.84 * (i + dice.between(0.25, 0.75)) / count);
  return places;
}

using Feature = void (*)(Design& design, double place);

template <Feature add_feature>
TransferFunction design(Dice& dice, const Volume& volume, bool labels) {
  Design design{dice, volume.statistics.range, {}};
  design.tf.unit_distance = dice.pick({1.0, 4.0}) * volume.grid.smallest_spacing();
  design.level = dice.pick({0.0, dice.between(0.002, 0.03)});
  design.add(-0.05, design.level);
  for (const double place : random_places(dice, labels)) add_feature(design, place);
  design.add(1.05, design.level);
  return design.tf;
}

void step(Design& design, double place) {
  design.add(place, design.level);
  design.level = design.level > 0.1 ? design.dice.between(0, 0.05) : design.dice.between(0.15, 0.7);
  design.add(place, design.level);
  if (!design.has_surface() || !design.dice.one_in(3)) design.show(design.dice.between(0.2, 0.9));
}

/// Near-Dirac, down to no width at all.
void spike(Design& design, double place) {
  const double half = design.dice.pick({5e-4, 5e-5, 5e-6, 0.0});
  design.add(place - half, design.level);
  design.add(place, design.dice.between(0.3, 0.95));
  design.add(place + half, design.level);
}

void plateau(Design& design, double place) {
  const double half = design.dice.between(0.005, 0.03), ramp = design.dice.pick({0.0, 1e-3, 0.01});
  const double top = design.dice.between(0.1, 0.6);
  design.add(place - half - ramp, design.level);
  design.add(place - half, top);
  design.show(design.dice.between(0.1, 0.6));
  design.add(place + half, top);
  design.add(place + half + ramp, design.level);
}

/// Points closer than 1e-5 of the range: a ramp to another level, and on the top of a peak.
void pair(Design& design, double place) {
  const double gap = design.dice.pick({9e-6, 1e-6, 1e-7});
  if (design.dice.one_in(2)) {
    design.add(place - 0.02, design.level);
    design.add(place, design.dice.between(0.5, 0.8));
    design.add(place + gap, design.dice.between(0.2, 0.4));
    design.add(place + 0.02, design.level);
    return;
  }
  design.add(place, design.level);
  design.level = design.level > 0.1 ? design.dice.between(0, 0.05) : design.dice.between(0.15, 0.6);
  design.add(place + gap, design.level);
  design.show(design.dice.between(0.2, 0.9));
}

/// Opacity 1: wide peaks, spikes and steps.
void opaque(Design& design, double place) {
  const double half = design.dice.pick({0.03, 0.002, 5e-5, 0.0});
  design.add(place - half, design.level);
  design.add(place, 1);
  design.add(place + half, design.level);
}

/// A translucent peak in which the colour changes, in one place at once.
void colors(Design& design, double place) {
  const double half = design.dice.pick({0.04, 0.01, 1e-3}), top = design.dice.between(0.1, 0.7);
  design.add(place - half, design.level);
  for (const double part : {-0.5, -0.25, -0.25}) design.add(place + part * half, (1 + part) * top);
  design.add(place, top);
  for (const double part : {0.125, 0.5}) design.add(place + part * half, (1 - part) * top);
  design.add(place + half, design.level);
}

}  // namespace

std::span<const FeatureKind> feature_kinds() {
  static constexpr FeatureKind kinds[] = {{"steps", design<step>},       {"spikes", design<spike>},
                                          {"plateaus", design<plateau>}, {"pairs of points", design<pair>},
                                          {"opaque", design<opaque>},    {"colour changes", design<colors>}};
  return kinds;
}

}  // namespace crest
