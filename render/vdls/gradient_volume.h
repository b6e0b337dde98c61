#pragma once

#include "render/gl/handle.h"
#include "render/resources/keyed_cache.h"
#include "render/volume/volume.h"

namespace crest {

/// The gradient at each grid point (VDLS, section 3.3): central differences, one-sided in the box's faces, in
/// units of the greatest component in the volume and quantised to 16 bits with sign, so that no gradient is
/// exactly 0. (The paper has 8 bits, which leave a tenth of the greatest gradient some 12 steps, and which
/// some drivers also filter in 8.) Between the points it is interpolated: away from the faces that is the
/// central difference of the trilinear field. 8 bytes a point. Throws Error when the driver cannot hold it.
GLuint gradient_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume);

}  // namespace crest
