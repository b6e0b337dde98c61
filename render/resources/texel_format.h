#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <functional>

#include "render/resources/keyed_cache.h"
#include "render/volume/volume.h"

namespace crest {

/// How the device holds a volume's values, in its stored_units(): as floats, or, where they are whole numbers
/// (volume/whole_values.h) and the driver filters 16 bits as well as floats, as R16. (8-bit textures are
/// filtered in 8 bits by some drivers.)
struct TexelKind {
  GLenum internal = GL_R32F, type = GL_FLOAT;
  std::size_t bytes = sizeof(float);  ///< a point
};
/// It may draw to find out.
TexelKind texel_kind(KeyedCache& held, const Volume& volume);

/// With what writes them.
struct TexelFormat : TexelKind {
  float scale = 1;  ///< what a texel is to be multiplied by
  /// Writes the texels of the points from `first` on. What voxels without a value have is a stand-in.
  std::function<void(std::size_t first, std::size_t count, std::byte* out)> write;
};

/// As texel_kind(). The volume must outlive it.
TexelFormat texel_format(KeyedCache& held, const Volume& volume);

}  // namespace crest
