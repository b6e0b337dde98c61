#include "render/vdls/gradient_volume.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>

#include "render/resources/volume_key.h"
#include "render/resources/volume_texture.h"

namespace crest {
namespace {

glm::dvec3 gradient_at(const Volume& volume, glm::ivec3 point) {
  const Grid& grid = volume.grid;
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 low = point, high = point;
    low[axis] = std::max(point[axis] - 1, 0);
    high[axis] = std::min(point[axis] + 1, grid.dims[axis] - 1);
    const double rise = double(volume.at(high.x, high.y, high.z)) - double(volume.at(low.x, low.y, low.z));
    gradient[axis] = rise / (grid.spacing[axis] * (high[axis] - low[axis]));
  }
  return gradient;
}

template <class Visit>
void for_each_point(const Grid& grid, const Visit& visit) {
  tbb::parallel_for(tbb::blocked_range<int>(0, grid.dims.z), [&](const tbb::blocked_range<int>& slices) {
    for (int k = slices.begin(); k < slices.end(); ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i) visit(glm::ivec3(i, j, k));
  });
}

/// No component of a gradient is greater.
double greatest_component(const Volume& volume) {
  const glm::dvec3 per_unit = volume.statistics.largest_difference / volume.grid.spacing;
  return std::max({per_unit.x, per_unit.y, per_unit.z});
}

struct GradientsKey : VolumeKey {
  using VolumeKey::VolumeKey;
  bool operator==(const GradientsKey&) const = default;
};

gl::TextureHandle upload_gradients(const Volume& volume) {
  constexpr double most = 32767;
  const glm::ivec3 dims = volume.grid.dims;
  const double greatest = greatest_component(volume), scale = greatest > 0 ? most / greatest : 0;
  std::vector<glm::i16vec4> codes(volume.grid.point_count());
  for_each_point(volume.grid, [&](glm::ivec3 p) {
    const std::size_t index =
        std::size_t(p.x) + std::size_t(dims.x) * (std::size_t(p.y) + std::size_t(dims.y) * std::size_t(p.z));
    codes[index] = glm::i16vec4(glm::round(scale * gradient_at(volume, p)), 0);
  });
  return upload_3d(dims, GL_RGBA16_SNORM, GL_RGBA, GL_SHORT, codes.data(), GL_LINEAR);
}

}  // namespace

GLuint gradient_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume) {
  return held
      .get(GradientsKey(volume), volume->grid.point_count() * sizeof(glm::i16vec4),
           [&] { return upload_gradients(*volume); })
      .id();
}

}  // namespace crest
