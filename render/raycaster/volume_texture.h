#pragma once

#include "render/gl/handle.h"
#include "render/raycaster/stored_units.h"
#include "render/volume/volume.h"

namespace crest {

/// A volume on the GPU.
struct VolumeTexture {
  gl::TextureHandle values;  ///< R32F in stored units, filtered linearly (8-bit textures are filtered in 8
                             ///< bits by some drivers)
  gl::TextureHandle
      empty_cells;  ///< R8UI, a cell a texel, 1 where a corner has no value; none when all have one
};

/// Throws Error when the driver cannot hold it.
VolumeTexture upload_volume(const Volume& volume, const StoredUnits& units);

}  // namespace crest
