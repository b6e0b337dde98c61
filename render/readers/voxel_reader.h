#pragma once

#include <cstdint>
#include <string>

#include "render/files/file_request.h"
#include "render/files/read_slabs.h"
#include "render/readers/voxel_header.h"

namespace crest {

/// Reads what a header describes, slab by slab: of several components or frames the one that the query says,
/// of the grid the part that it says. Fills the grid, the values, the file's type, the direction and the
/// note. The query may also say ?subtract=NUMBER: it is subtracted before the values become 32-bit float.
/// Throws Error: what the file lacks, before it is read, or what cannot be read. `keys`: more that the query
/// may say, each after a comma.
Volume read_voxels(const FileRequest& request, const VoxelHeader& header, const std::string& keys = "");

/// The same with bytes that `read` finds, in the header's byte order, which takes `held_besides` bytes of
/// memory for it; the header's `data` is not used.
Volume read_voxels(const FileRequest& request, const VoxelHeader& header, const std::string& keys,
                   const ReadValues& read, std::uint64_t held_besides);

}  // namespace crest
