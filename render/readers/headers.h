#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "render/readers/voxel_header.h"

namespace crest {

// Each throws Error when the file is not of the format, or not in a form that can be read.
VoxelHeader read_nrrd_header(const std::filesystem::path& path);
VoxelHeader read_metaimage_header(const std::filesystem::path& path);
VoxelHeader read_nifti_header(const std::filesystem::path& path);
VoxelHeader read_mrc_header(const std::filesystem::path& path);
VoxelHeader read_npy_header(const std::filesystem::path& path);

/// The lines "field: value" of a NRRD header, by their names in lower case.
using NrrdFields = std::map<std::string, std::string>;
/// What the fields say of the axes: layout, spacing, origin and direction (nrrd_axes.cpp).
void take_nrrd_axes(const std::string& name, const NrrdFields& fields, VoxelHeader& header);

}  // namespace crest
