#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <functional>
#include <memory>

#include "render/resources/keyed_cache.h"
#include "render/volume/volume.h"

namespace crest {

/// How the device holds a volume's values, in its stored_units(): as floats, or, where they are whole numbers
/// (volume/whole_values.h) and the driver filters 16 bits as well as floats, as R16. (8-bit textures are
/// filtered in 8 bits by some drivers.)
struct TexelFormat {
  GLenum internal = 0, type = 0;
  std::size_t bytes = 0;  ///< a point
  float scale = 1;        ///< what a texel is to be multiplied by
  /// Writes the texels of the points from `first` on. What voxels without a value have is a stand-in.
  std::function<void(std::size_t first, std::size_t count, std::byte* out)> write;
};

/// It may draw to find out. The volume must outlive it.
TexelFormat texel_format(KeyedCache& held, const Volume& volume);

/// Bytes a point, at most.
std::size_t texel_bytes(const Volume& volume);

}  // namespace crest
