#pragma once

#include <bit>
#include <cstdint>
#include <glm/ext/vector_uint3_sized.hpp>
#include <string>

#include "render/readers/voxel_data.h"
#include "render/volume/convert.h"
#include "render/volume/volume.h"

namespace crest {

/// How stored values follow each other, counted in values: point (i,j,k) of component c in frame t is value
/// start + dot(stride, (i,j,k)) + c * component_stride + t * frame_stride.
struct VoxelLayout {
  glm::u64vec3 dims{0}, stride{0};
  std::uint64_t components = 1, component_stride = 0;
  std::uint64_t frames = 1, frame_stride = 0;
  std::uint64_t start = 0;

  std::uint64_t stored_values() const { return dims.x * dims.y * dims.z * components * frames; }
};

/// Components fastest, then x, y, z and frames: how most formats store them.
VoxelLayout interleaved(glm::u64vec3 dims, std::uint64_t components = 1, std::uint64_t frames = 1);

/// All that a header says about how its voxels are read.
struct VoxelHeader {
  VoxelData data;
  VoxelLayout layout;
  ScalarType type = ScalarType::float32;     ///< of the stored values
  std::endian endian = std::endian::little;  ///< of their bytes
  LinearMap scaling;                         ///< from the stored values to the volume's
  glm::dvec3 spacing{1}, origin{0};          ///< as repair_geometry() takes them: 0 and NaN may be there
  glm::dmat3 direction{1};                   ///< of the axes, as columns
  bool is_in_patient = false;                ///< as Volume has it
  std::vector<std::string> component_names;  ///< where they have some: "red"
  std::string note;
};

/// `more` behind `note`, with "; " between them.
void add_note(std::string& note, const std::string& more);

}  // namespace crest
