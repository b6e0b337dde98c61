#pragma once

#include <memory>

#include "render/gl/handle.h"
#include "render/resources/resources.h"
#include "render/volume/bricks.h"
#include "render/volume/volume.h"

namespace crest {

/// A 3D texture, filtered by `filter` and clamped at its edges. Throws Error when the driver has no room for
/// it.
gl::TextureHandle upload_3d(glm::ivec3 size, GLenum internal_format, GLenum format, GLenum type,
                            const void* data, GLint filter);

/// Whether the driver cannot hold the volume in a texture of its own, or that would take more than
/// `resources.whole_volume_bytes`. Then it is drawn from those bricks that a picture reads.
bool is_in_bricks(Resources& resources, const std::shared_ptr<const Volume>& volume);

/// What pictures of it will ask for, ahead of them. Throws Error when the driver cannot hold it. It may draw.
void hold_volume(Resources& resources, const std::shared_ptr<const Volume>& volume);

struct VolumeUnits {
  GLuint volume, brick_table;
};

/// Gives the program what field.glsl asks of it: the volume (as texel_format.h says), or, where `bricks` is
/// not null, as features.bricks, so much of it. Throws Error when the driver cannot hold it.
void bind_volume(Resources& resources, const std::shared_ptr<const Volume>& volume,
                 const std::shared_ptr<const BrickSet>& bricks, VolumeUnits units, GLuint program);

/// Where no voxel has a value: R8UI, a cell a texel, 1 where a point that a filter of this radius reaches has
/// no value. Throws Error as above.
GLuint empty_cells_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume, int radius);

}  // namespace crest
