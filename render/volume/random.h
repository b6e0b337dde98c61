#pragma once

#include <cstdint>

namespace crest {

/// SplitMix64: a stream of random numbers that is the same on every machine, unlike <random>'s distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    return mix(state_);
  }
  /// Uniform in [min, max).
  double uniform(double min, double max) { return min + (max - min) * (double(bits() >> 11) * 0x1p-53); }

  /// A hash of 64 bits.
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state_;
};

}  // namespace crest
