#pragma once

#include <memory>

#include "render/gl/handle.h"
#include "render/resources/keyed_cache.h"
#include "render/volume/volume.h"

namespace crest {

/// A 3D texture, filtered by `filter` and clamped at its edges. Throws Error when the driver has no room for
/// it.
gl::TextureHandle upload_3d(glm::ivec3 size, GLenum internal_format, GLenum format, GLenum type,
                            const void* data, GLint filter);

/// A volume on the GPU: R32F in stored_units() of its range, filtered linearly (8-bit textures are filtered
/// in 8 bits by some drivers), with stand-ins for voxels without a value. 4 bytes a point. Throws Error when
/// the driver cannot hold it.
GLuint volume_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume);

/// Where they are: R8UI, a cell a texel, 1 where a point that a filter of this radius reaches has no value.
/// Throws Error as above.
GLuint empty_cells_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume, int radius);

}  // namespace crest
