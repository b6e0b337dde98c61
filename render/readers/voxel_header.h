#pragma once

#include <bit>
#include <string>

#include "render/files/voxel_layout.h"
#include "render/readers/voxel_data.h"
#include "render/volume/convert.h"
#include "render/volume/volume.h"

namespace crest {

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
