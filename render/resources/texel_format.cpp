#include "render/resources/texel_format.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>

#include "render/classify/stored_units.h"
#include "render/gl/filter_weights.h"
#include "render/volume/empty_cells.h"
#include "render/volume/whole_values.h"

namespace crest {
namespace {

struct SixteenBitsKey {
  bool operator==(const SixteenBitsKey&) const = default;
};

/// Whether the texture unit filters 16-bit texels as well as floats.
bool filters_16_bits(KeyedCache& held) {
  return held.get(SixteenBitsKey(), 0, [] {
    constexpr double rounding = 0x1p-16;
    return gl::measure_weight_error(GL_R16) <= gl::measure_weight_error(GL_R32F) + rounding;
  });
}

/// Spread over the 16 bits by a power of two, so that a filter of few digits loses as little as may be.
TexelFormat whole_format(const Volume& volume, const WholeValues& whole) {
  constexpr int most = std::numeric_limits<std::uint16_t>::max();
  int spread = 1;
  while (2 * spread * std::max(whole.most, 1) <= most) spread *= 2;
  return {GL_R16, GL_UNSIGNED_SHORT, sizeof(std::uint16_t), float(most) / float(spread),
          [&volume, whole, spread](std::size_t first, std::size_t count, std::byte* out) {
            write_steps(volume, whole, first, spread, {reinterpret_cast<std::uint16_t*>(out), count});
          }};
}

}  // namespace

TexelFormat texel_format(KeyedCache& held, const Volume& volume) {
  if (const auto whole = whole_values(volume); whole && filters_16_bits(held))
    return whole_format(volume, *whole);
  std::shared_ptr<const Voxels> stand_ins;
  if (volume.has_empty_cells()) stand_ins = std::make_shared<const Voxels>(finite_values(volume));
  return {GL_R32F, GL_FLOAT, sizeof(float), 1,
          [&volume, stand_ins, units = stored_units(volume)](std::size_t first, std::size_t count,
                                                             std::byte* out) {
            std::vector<float> room;
            const Voxels& voxels = stand_ins ? *stand_ins : volume.values;
            const std::span<const float> values = voxels.part(first, count, room);
            const std::span<float> texels(reinterpret_cast<float*>(out), count);
            std::ranges::transform(values, texels.begin(), [&](float value) { return units.stored(value); });
          }};
}

std::size_t texel_bytes(const Volume& volume) {
  return whole_values(volume) ? sizeof(std::uint16_t) : sizeof(float);
}

}  // namespace crest
