#include "render/files/voxel_layout.h"

namespace crest {

VoxelLayout interleaved(glm::u64vec3 dims, std::uint64_t components, std::uint64_t frames) {
  VoxelLayout layout{dims, {components, components * dims.x, components * dims.x * dims.y}};
  layout.components = components;
  layout.component_stride = 1;
  layout.frames = frames;
  layout.frame_stride = components * dims.x * dims.y * dims.z;
  return layout;
}

VoxelLayout one_of(const VoxelLayout& layout, std::uint64_t component, std::uint64_t frame) {
  VoxelLayout one{layout.dims, layout.stride};
  one.start = layout.start + component * layout.component_stride + frame * layout.frame_stride;
  return one;
}

VoxelLayout part_of(const VoxelLayout& layout, const GridPart& part) {
  VoxelLayout taken{part.dims(), layout.stride * part.stride};
  taken.start = layout.place(part.first);
  return taken;
}

}  // namespace crest
