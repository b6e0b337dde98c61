#pragma once

#include "render/gl/handle.h"
#include "render/raycaster/stored_units.h"
#include "render/volume/volume.h"

namespace crest {

/// A 3D texture, filtered by `filter` and clamped at its edges. Throws Error when the driver has no room for
/// it.
gl::TextureHandle upload_3d(glm::ivec3 size, GLenum internal_format, GLenum format, GLenum type,
                            const void* data, GLint filter);

/// A volume on the GPU: R32F in stored units, filtered linearly (8-bit textures are filtered in 8 bits by
/// some drivers), with stand-ins for voxels without a value. Throws Error when the driver cannot hold it.
gl::TextureHandle upload_volume(const Volume& volume, const StoredUnits& units);

/// Where they are: R8UI, a cell a texel, 1 where a point that a filter of this radius reaches has no value.
/// Throws Error as above.
gl::TextureHandle upload_empty_cells(const Volume& volume, int radius);

/// A texel (R8UI) for each macrocell.
gl::TextureHandle upload_macrocells(glm::ivec3 dims, const std::vector<std::uint8_t>& values);

}  // namespace crest
