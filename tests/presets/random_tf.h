#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "presets/transfer_function.h"

namespace crest {

/// A TF in a volume's values, of 2 to `most_points` points, with steps, spikes down to 1e-7 of the range and
/// points that are there twice, in a range of any size and place.
inline TransferFunction random_tf(std::mt19937& random, std::size_t most_points = 2000) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double width = std::pow(10, unit(random) * 8 - 4);
  const double min =
      random() % 3 == 0 ? 0 : (unit(random) - 0.5) * width * std::pow(10, double(random() % 3));
  const std::size_t count = 2 + std::size_t(std::pow(unit(random), 4) * double(most_points - 2));
  TransferFunction tf;
  tf.unit_distance = std::pow(10, unit(random) * 4 - 2);
  const auto add = [&](double place, double opacity) {
    tf.points.push_back({.value = min + place * width,
                         .color = {unit(random), unit(random), random() % 2 ? 1.0 : 0.0},
                         .opacity = opacity,
                         .surface = {},
                         .unknown = {}});
  };
  while (tf.points.size() < count) {
    const double place = unit(random), opacity = random() % 4 ? unit(random) : double(random() % 2);
    switch (random() % 5) {
      case 0: {  // a spike
        const double half = std::pow(10, -1 - 6 * unit(random));
        add(place - half, 0.1 * opacity);
        add(place, opacity);
        add(place + half, 0.1 * opacity);
        break;
      }
      case 1:  // a step
        add(place, opacity);
        add(place, unit(random));
        break;
      case 2:  // a spike of no width
        for (const double o : {0.0, opacity, 0.0}) add(place, o);
        break;
      default:
        add(place, opacity);
    }
  }
  std::ranges::stable_sort(tf.points, {}, &ControlPoint::value);
  return tf;
}

/// Whether a TF has this colour and opacity somewhere within `moved` of a value, each number to `off`.
inline bool has_near(const TransferFunction& tf, double value, const Classified& found, double moved,
                     double off) {
  std::vector<Classified> near{evaluate_left(tf, value - moved), evaluate_right(tf, value - moved),
                               evaluate_left(tf, value + moved), evaluate_right(tf, value + moved)};
  const auto first = std::ranges::lower_bound(tf.points, value - moved, {}, &ControlPoint::value);
  for (auto p = first; p != tf.points.end() && p->value <= value + moved; ++p)
    near.push_back({p->color, p->opacity});
  for (int channel = 0; channel < 4; ++channel) {
    const auto of = [channel](const Classified& c) { return channel < 3 ? c.color[channel] : c.opacity; };
    const auto [least, most] = std::ranges::minmax(near, {}, of);
    if (of(found) < of(least) - off || of(found) > of(most) + off) return false;
  }
  return true;
}

/// Whether two TFs are the same but for points that moved by up to `moved`, and numbers that are off by
/// `off`: at each value the one has what the other has somewhere within that distance. Says where they are
/// not, or nothing.
inline std::string why_different(const TransferFunction& tf, const TransferFunction& other, double moved,
                                 double off) {
  std::vector<double> values;
  for (std::size_t i = 0; i < other.points.size(); ++i) {
    values.push_back(other.points[i].value);
    if (i > 0) values.push_back(0.5 * (other.points[i - 1].value + other.points[i].value));
  }
  for (const ControlPoint& p : tf.points) values.push_back(p.value);
  for (const double value : values)
    for (const Classified& found : {evaluate_left(other, value), evaluate_right(other, value)})
      if (!has_near(tf, value, found, moved, off))
        return "at " + std::to_string(value) + " opacity " + std::to_string(found.opacity) + ", where " +
               std::to_string(evaluate(tf, value).opacity) + " was";
  return "";
}

}  // namespace crest
