#pragma once

#include <cmath>
#include <cstdint>

#include "render/volume/dual.h"
#include "render/volume/random.h"

namespace crest {

/// Perlin's improved gradient noise (2002): about one feature a unit, twice differentiable, within [-1.04,
/// 1.04]. The lattice does not repeat.
template <class T>
T gradient_noise(const Point<T>& p, std::uint64_t seed) {
  const double cell[3] = {std::floor(value_of(p.x)), std::floor(value_of(p.y)), std::floor(value_of(p.z))};
  const T f[3] = {p.x - cell[0], p.y - cell[1], p.z - cell[2]};
  const auto fade = [](const T& t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); };
  const auto mix = [](const T& a, const T& b, const T& t) { return a + (b - a) * t; };
  const T u = fade(f[0]), v = fade(f[1]), w = fade(f[2]);

  // One of the twelve directions to a cube's edges (four of them twice), dotted with the offset.
  const auto corner = [&](int i, int j, int k) -> T {
    const auto lattice = [&](int axis, int step) { return std::uint64_t(std::int64_t(cell[axis]) + step); };
    const std::uint64_t hash = Random::mix(lattice(0, i) * 0x8da6b343u + lattice(1, j) * 0xd8163841u +
                                           lattice(2, k) * 0xcb1ab31fu + seed * 0x9e3779b97f4a7c15u);
    const T x = f[0] - double(i), y = f[1] - double(j), z = f[2] - double(k);
    const unsigned h = unsigned(hash >> 60);
    const T a = h < 8 ? x : y;
    const T b = h < 4 ? y : (h == 12 || h == 14 ? x : z);
    return ((h & 1u) != 0 ? -a : a) + ((h & 2u) != 0 ? -b : b);
  };
  const T near = mix(mix(corner(0, 0, 0), corner(1, 0, 0), u), mix(corner(0, 1, 0), corner(1, 1, 0), u), v);
  const T far = mix(mix(corner(0, 0, 1), corner(1, 0, 1), u), mix(corner(0, 1, 1), corner(1, 1, 1), u), v);
  return mix(near, far, w);
}

/// `octaves` of it, each of twice the frequency and half the size.
template <class T>
T fractal_noise(const Point<T>& p, int octaves, std::uint64_t seed) {
  T sum = 0.0;
  double frequency = 1, amplitude = 1;
  for (int octave = 0; octave < octaves; ++octave) {
    sum = sum + gradient_noise(Point<T>{p.x * frequency, p.y * frequency, p.z * frequency},
                               seed + std::uint64_t(octave)) *
                    amplitude;
    frequency *= 2;
    amplitude /= 2;
  }
  return sum;
}

}  // namespace crest
