#pragma once

#include <cstddef>
#include <span>

#include "render/volume/volume.h"

namespace crest {

/// What a header says that the stored values are to be multiplied by, and what is to be added.
struct LinearMap {
  double slope = 1, intercept = 0;
  bool operator==(const LinearMap&) const = default;
};

/// `out.size()` values of `type` as float32, mapped in double and rounded once; `stride` is the distance
/// between them in `bytes`, in values (3 takes one component of RGB). `bytes` starts at the first value; it
/// need not be aligned.
void convert_to_float(std::span<const std::byte> bytes, ScalarType type, std::size_t stride,
                      std::span<float> out, LinearMap map = {});

/// Reverses the bytes of each value in place.
void swap_bytes(std::span<std::byte> bytes, std::size_t value_size);

}  // namespace crest
