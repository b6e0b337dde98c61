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

/// A volume on the GPU, in its stored_units(), filtered linearly: R32F, with stand-ins for voxels without a
/// value; where the values are whole numbers (volume/whole_values.h), R16, if the driver filters it as well
/// as floats (8-bit textures are filtered in 8 bits by some). Throws Error when the driver cannot hold it.
struct VolumeTexture {
  gl::TextureHandle texture;
  float scale = 1;  ///< what a texel is to be multiplied by; features.whole_values says whether it is rounded
};
const VolumeTexture& volume_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume);

/// Bytes a point of it, at most.
std::size_t texture_bytes_per_point(const Volume& volume);

/// Binds it to the unit, and gives the program what field.glsl asks of it.
void bind_volume(KeyedCache& held, const std::shared_ptr<const Volume>& volume, GLuint unit, GLuint program);

/// Where they are: R8UI, a cell a texel, 1 where a point that a filter of this radius reaches has no value.
/// Throws Error as above.
GLuint empty_cells_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume, int radius);

}  // namespace crest
