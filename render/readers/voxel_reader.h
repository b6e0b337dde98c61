#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "render/files/file_request.h"
#include "render/readers/voxel_header.h"

namespace crest {

/// The stored bytes of the values [first, first + count), in the header's byte order.
using FetchValues = std::function<std::vector<std::byte>(std::uint64_t first, std::uint64_t count)>;

/// Reads what a header describes: of several components or frames the one that the query says. Fills the
/// grid, the values, the file's type, the direction and the note. The query may also say ?subtract=NUMBER:
/// it is subtracted before the values become 32-bit float. Throws Error: what the file lacks, before it is
/// read, or what cannot be read. `keys`: more that the query may say, each after a comma.
Volume read_voxels(const FileRequest& request, const VoxelHeader& header, const std::string& keys = "");

/// The same with bytes that `fetch` finds; the header's `data` is not used.
Volume read_voxels(const FileRequest& request, const VoxelHeader& header, const std::string& keys,
                   const FetchValues& fetch);

}  // namespace crest
