#include "render/resources/volume_texture.h"

#include <fmt/core.h>

#include <algorithm>

#include "render/classify/stored_units.h"
#include "render/gl/errors.h"
#include "render/gl/texture.h"
#include "render/resources/volume_key.h"
#include "render/volume/empty_cells.h"

namespace crest {

gl::TextureHandle upload_3d(glm::ivec3 size, GLenum internal_format, GLenum format, GLenum type,
                            const void* data, GLint filter) {
  gl::TextureHandle texture = gl::make_texture(GL_TEXTURE_3D, filter);
  gl::require_no_error("preparing a volume");
  glTextureStorage3D(texture.id(), 1, internal_format, size.x, size.y, size.z);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (glGetError() == GL_NO_ERROR)
    glTextureSubImage3D(texture.id(), 0, 0, 0, 0, size.x, size.y, size.z, format, type, data);
  if (glGetError() != GL_NO_ERROR)
    throw gl::NoRoom(
        fmt::format("the graphics driver has no room for a volume of {}x{}x{}", size.x, size.y, size.z));
  return texture;
}

namespace {

struct ValuesKey : VolumeKey {
  using VolumeKey::VolumeKey;
  bool operator==(const ValuesKey&) const = default;
};

struct EmptyCellsKey : VolumeKey {
  EmptyCellsKey(const std::shared_ptr<const Volume>& volume, int r) : VolumeKey(volume), radius(r) {}
  int radius;
  bool operator==(const EmptyCellsKey&) const = default;
};

gl::TextureHandle upload_volume(const Volume& volume) {
  const StoredUnits units = stored_units(volume.statistics.range);
  const glm::ivec3 dims = volume.grid.dims;
  GLint largest = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
  if (std::max({dims.x, dims.y, dims.z}) > largest)
    throw Error(fmt::format("{}: {}x{}x{} points are too many for this graphics driver: at most {} an axis",
                            volume.name, dims.x, dims.y, dims.z, largest));
  const auto upload_values = [&](const std::vector<float>& values) {
    return upload_3d(dims, GL_R32F, GL_RED, GL_FLOAT, values.data(), GL_LINEAR);
  };
  if (volume.has_empty_cells()) return upload_values(units.stored(finite_values(volume)));
  const std::vector<float> values = volume.values.to_floats();
  return units.is_identity() ? upload_values(values) : upload_values(units.stored(values));
}

gl::TextureHandle upload_empty_cells(const Volume& volume, int radius) {
  return upload_3d(volume.grid.dims - 1, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                   find_empty_cells(volume, radius).data(), GL_NEAREST);
}

}  // namespace

GLuint volume_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume) {
  return held
      .get(ValuesKey(volume), volume->grid.point_count() * sizeof(float),
           [&] { return upload_volume(*volume); })
      .id();
}

GLuint empty_cells_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume, int radius) {
  return held
      .get(EmptyCellsKey(volume, radius), volume->grid.point_count(),
           [&] { return upload_empty_cells(*volume, radius); })
      .id();
}

}  // namespace crest
