#pragma once

#include "render/files/file_request.h"
#include "render/volume/volume.h"

namespace crest {

/// Raw voxels, as the query, a sidecar or the file's name says. Fills what FileLibrary's readers do.
Volume read_raw(const FileRequest& request);

}  // namespace crest
