#pragma once

#include <filesystem>
#include <string>

namespace crest {

/// What a file or folder of a format that is not read is, and what makes one of it that is: HDF5, Zarr and
/// NumPy's archives, VTK's other grids and lists of files, by their extensions. Empty for others.
std::string how_to_convert(const std::filesystem::path& path);

}  // namespace crest
