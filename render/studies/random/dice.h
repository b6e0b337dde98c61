#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <utility>
#include <vector>

#include "render/volume/random.h"

namespace crest {

/// Choices by chance, the same on every machine.
struct Dice {
  Random random;

  double between(double min, double max) { return random.uniform(min, max); }
  glm::dvec3 vector(double min, double max) {
    const double x = between(min, max), y = between(min, max), z = between(min, max);
    return {x, y, z};
  }
  int one_of(int count) { return int(random.bits() % std::uint64_t(count)); }
  bool one_in(int count) { return one_of(count) == 0; }
  template <class T>
  T pick(std::initializer_list<T> choices) {
    return choices.begin()[one_of(int(choices.size()))];
  }
  template <class T>
  void shuffle(std::vector<T>& list) {
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[std::size_t(one_of(int(i)))]);
  }
};

}  // namespace crest
