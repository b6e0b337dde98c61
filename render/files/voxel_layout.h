#pragma once

#include <cstdint>
#include <glm/ext/vector_uint3_sized.hpp>

#include "render/volume/grid_part.h"

namespace crest {

/// How stored values follow each other, counted in values: point (i,j,k) of component c in frame t is value
/// start + dot(stride, (i,j,k)) + c * component_stride + t * frame_stride.
struct VoxelLayout {
  glm::u64vec3 dims{0}, stride{0};
  std::uint64_t components = 1, component_stride = 0;
  std::uint64_t frames = 1, frame_stride = 0;
  std::uint64_t start = 0;

  std::uint64_t stored_values() const { return dims.x * dims.y * dims.z * components * frames; }
  std::uint64_t place(glm::u64vec3 p) const {
    return start + stride.x * p.x + stride.y * p.y + stride.z * p.z;
  }
};

/// Components fastest, then x, y, z and frames: how most formats store them.
VoxelLayout interleaved(glm::u64vec3 dims, std::uint64_t components = 1, std::uint64_t frames = 1);

/// One component of one frame.
VoxelLayout one_of(const VoxelLayout& layout, std::uint64_t component, std::uint64_t frame);
/// A part of the layout's points, where the layout has one component and one frame.
VoxelLayout part_of(const VoxelLayout& layout, const GridPart& part);

}  // namespace crest
