#pragma once

#include <algorithm>
#include <initializer_list>
#include <random>

#include "presets/transfer_function.h"

namespace crest {

/// A TF from pairs of value and opacity.
inline TransferFunction tf_of(std::initializer_list<std::pair<double, double>> points) {
  TransferFunction tf;
  for (const auto& [value, opacity] : points) {
    tf.points.emplace_back();
    tf.points.back().value = value;
    tf.points.back().opacity = opacity;
  }
  return tf;
}

/// A TF with runs, steps, spikes and ends of every kind: few different values and opacities, in any order.
inline TransferFunction random_tf(std::mt19937& random, int most_points) {
  TransferFunction tf;
  const int count = 1 + int(random() % unsigned(most_points));
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < count; ++i) {
    ControlPoint point;
    point.value = random() % 3 ? unit(random) : double(random() % 5) / 4;
    point.opacity = random() % 3 ? unit(random) : double(random() % 4) / 3;
    point.color = {unit(random), unit(random), unit(random)};
    tf.points.push_back(point);
  }
  std::stable_sort(tf.points.begin(), tf.points.end(), [](auto& a, auto& b) { return a.value < b.value; });
  tf.spike_width = 0.3;
  return tf;
}

}  // namespace crest
