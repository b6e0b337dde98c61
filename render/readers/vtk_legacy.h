#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// One array of a legacy VTK file, and where its numbers begin.
struct VtkArray {
  enum class Section { dataset, points, cells };
  std::string name;
  Section section = Section::dataset;
  bool is_scalars = false;  ///< said by SCALARS, not by VECTORS, FIELD or others
  ScalarType type = ScalarType::float32;
  std::uint64_t components = 1, tuples = 0;
  std::uint64_t offset = 0;
  std::size_t line = 0;    ///< in which its numbers begin
  bool is_of_255 = false;  ///< text of bytes (COLOR_SCALARS), which says 0.2 for 51
};

/// What a legacy file says, in the order of the VTK User's Guide's "simple legacy formats".
struct VtkLegacy {
  bool is_text = false;
  glm::ivec3 dims{0};
  glm::dvec3 spacing{1}, origin{0};
  std::vector<VtkArray> arrays;
  std::string unread;  ///< what follows that is no part of the format; or empty
};

/// Throws Error for what is not a legacy file with structured points.
VtkLegacy scan_vtk_legacy(const std::filesystem::path& path);

}  // namespace crest
