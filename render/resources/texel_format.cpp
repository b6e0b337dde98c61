#include "render/resources/texel_format.h"

#include <algorithm>
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
void write_whole(TexelFormat& format, const Volume& volume, const WholeValues& whole) {
  constexpr int most = std::numeric_limits<std::uint16_t>::max();
  int spread = 1;
  while (2 * spread * std::max(whole.most, 1) <= most) spread *= 2;
  format.scale = float(most) / float(spread);
  format.write = [&volume, whole, spread](std::size_t first, std::size_t count, std::byte* out) {
    write_steps(volume, whole, first, spread, {reinterpret_cast<std::uint16_t*>(out), count});
  };
}

}  // namespace

TexelKind texel_kind(KeyedCache& held, const Volume& volume) {
  if (whole_values(volume) && filters_16_bits(held))
    return {GL_R16, GL_UNSIGNED_SHORT, sizeof(std::uint16_t)};
  return {};
}

TexelFormat texel_format(KeyedCache& held, const Volume& volume) {
  TexelFormat format{texel_kind(held, volume), 1, {}};
  if (format.internal == GL_R16) {
    write_whole(format, volume, *whole_values(volume));
    return format;
  }
  format.write = [&volume, units = stored_units(volume)](std::size_t first, std::size_t count,
                                                         std::byte* out) {
    const std::span<float> texels(reinterpret_cast<float*>(out), count);
    write_finite(volume, first, texels);
    for (float& texel : texels) texel = units.stored(texel);
  };
  return format;
}

}  // namespace crest
