#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// For each cell, x fastest, (dims-1) of them: 1 where it is empty, since one of its corners is NaN or Inf;
/// for a filter of radius 2, also one of the points around these, so that no sample is made from a stand-in.
std::vector<std::uint8_t> find_empty_cells(const Volume& volume, int radius = 1);

/// The values of the points from `first` on, with finite stand-ins (the mean of a voxel's finite neighbours,
/// or the least value) for those that are not: filtering multiplies even a NaN of weight 0.
void write_finite(const Volume& volume, std::size_t first, std::span<float> out);

}  // namespace crest
