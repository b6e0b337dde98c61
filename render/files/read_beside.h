#pragma once

#include "render/files/file_modules.h"
#include "render/files/file_request.h"
#include "render/files/image.h"
#include "render/volume/volume.h"

namespace crest {

// Files that need a library, read by a program of its own (render/reader) under limits on memory and time:
// what a damaged file does to a library ends that program alone. Each throws Error: what the reader says, or
// why it failed. All that it answers is checked.

/// Fills the grid, the values, the file's type, the direction and the note.
Volume read_beside(FileForm form, const FileRequest& request);
/// As read_image().
Image read_picture_beside(const FileRequest& request);
/// As preset_in_picture().
std::string read_preset_beside(const FileRequest& request);

}  // namespace crest
