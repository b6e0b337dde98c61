#include <cmath>
#include <numbers>
#include <vector>

#include "render/volume/builtin_fields.h"
#include "render/volume/random.h"

namespace crest {

/// A sum of plane waves of random directions and phases, their frequencies spread evenly over the band: its
/// spectrum is exactly within it. Of variance 1.
FormulaField noise_field(const NoiseBand& band, std::uint64_t seed) {
  using std::numbers::pi;
  constexpr int count = 32;
  struct Wave {
    glm::dvec3 k;
    double phase;
  };
  std::vector<Wave> waves;
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const double frequency = band.low + (band.high - band.low) * (i + 0.5) / count;
    const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
    const glm::dvec3 direction(r * std::cos(angle), r * std::sin(angle), z);
    waves.push_back({direction * (2 * pi * frequency), random.uniform(0, 2 * pi)});
  }
  return field_of([waves](const auto& p) {
    auto sum = p.x * 0.0;
    for (const Wave& wave : waves)
      sum = sum + cos(p.x * wave.k.x + p.y * wave.k.y + p.z * wave.k.z + wave.phase);
    return sum * std::sqrt(2.0 / count);
  });
}

}  // namespace crest
