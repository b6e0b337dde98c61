#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "render/volume/volume.h"

namespace crest {

/// Values that lie a whole number of steps above the least one: base + step * 0 ... base + step * most.
struct WholeValues {
  double base = 0, step = 1;  ///< step is a power of two
  int most = 0;               ///< at most 65535
};

/// Of a volume that is stored in 8 or 16 bits, where no value was rounded when it was mapped.
std::optional<WholeValues> whole_values(const Volume& volume);

/// The steps of the points from `first` on, `out.size()` of them, times `scale`. `whole` is whole_values().
void write_steps(const Volume& volume, const WholeValues& whole, std::size_t first, int scale,
                 std::span<std::uint16_t> out);

}  // namespace crest
