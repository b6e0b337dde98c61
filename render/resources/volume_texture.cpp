#include "render/resources/volume_texture.h"

#include <fmt/core.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "render/gl/errors.h"
#include "render/gl/texture.h"
#include "render/gl/uniforms.h"
#include "render/resources/brick_atlas.h"
#include "render/resources/texel_format.h"
#include "render/resources/volume_key.h"
#include "render/volume/empty_cells.h"

namespace crest {

namespace {

gl::TextureHandle make_3d(glm::ivec3 size, GLenum internal_format, GLint filter) {
  gl::TextureHandle texture = gl::make_texture(GL_TEXTURE_3D, filter);
  gl::require_no_error("preparing a volume");
  glTextureStorage3D(texture.id(), 1, internal_format, size.x, size.y, size.z);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  return texture;
}

void require_room(glm::ivec3 size) {
  if (glGetError() != GL_NO_ERROR)
    throw gl::NoRoom(
        fmt::format("the graphics driver has no room for a volume of {}x{}x{}", size.x, size.y, size.z));
}

}  // namespace

gl::TextureHandle upload_3d(glm::ivec3 size, GLenum internal_format, GLenum format, GLenum type,
                            const void* data, GLint filter) {
  gl::TextureHandle texture = make_3d(size, internal_format, filter);
  require_room(size);
  glTextureSubImage3D(texture.id(), 0, 0, 0, 0, size.x, size.y, size.z, format, type, data);
  require_room(size);
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

struct AtlasKey : VolumeKey {
  using VolumeKey::VolumeKey;
  bool operator==(const AtlasKey&) const = default;
};

struct InBricksKey : VolumeKey {
  using VolumeKey::VolumeKey;
  bool operator==(const InBricksKey&) const = default;
};

/// A slab at a time, since the whole would take as much memory again.
gl::TextureHandle upload_whole(const Volume& volume, const TexelFormat& format) {
  constexpr std::size_t slab_points = std::size_t(1) << 22, grain = std::size_t(1) << 16;
  const glm::ivec3 dims = volume.grid.dims;
  gl::TextureHandle texture = make_3d(dims, format.internal, GL_LINEAR);
  require_room(dims);
  const std::size_t slice = std::size_t(dims.x) * std::size_t(dims.y);
  const int depth = int(std::clamp<std::size_t>(slab_points / slice, 1, std::size_t(dims.z)));
  std::vector<std::byte> slab(slice * std::size_t(depth) * format.bytes);
  for (int z = 0; z < dims.z; z += depth) {
    const int slices = std::min(depth, dims.z - z);
    const std::size_t first = slice * std::size_t(z), count = slice * std::size_t(slices);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& part) {
      format.write(first + part.begin(), part.size(), slab.data() + part.begin() * format.bytes);
    });
    glTextureSubImage3D(texture.id(), 0, 0, 0, z, dims.x, dims.y, slices, GL_RED, format.type, slab.data());
    require_room(dims);
  }
  return texture;
}

struct WholeVolume {
  gl::TextureHandle texture;
  float scale;
};

const WholeVolume& whole_volume(Resources& resources, const std::shared_ptr<const Volume>& volume) {
  return resources.held.get(ValuesKey(volume),
                            volume->grid.point_count() * texel_kind(resources.held, *volume).bytes, [&] {
                              const TexelFormat format = texel_format(resources.held, *volume);
                              return WholeVolume{upload_whole(*volume, format), format.scale};
                            });
}

BrickAtlas& brick_atlas(Resources& resources, const std::shared_ptr<const Volume>& volume) {
  return *resources.held.get(AtlasKey(volume), 0, [&] {
    return std::make_unique<BrickAtlas>(*volume, texel_format(resources.held, *volume));
  });
}

gl::TextureHandle upload_empty_cells(const Volume& volume, int radius) {
  return upload_3d(volume.grid.dims - 1, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                   find_empty_cells(volume, radius).data(), GL_NEAREST);
}

}  // namespace

bool is_in_bricks(Resources& resources, const std::shared_ptr<const Volume>& volume) {
  return resources.held.get(InBricksKey(volume), 0, [&] {
    const TexelKind kind = texel_kind(resources.held, *volume);
    return volume->grid.point_count() * kind.bytes > resources.whole_volume_bytes ||
           !takes_texture(volume->grid.dims, kind.internal);
  });
}

void hold_volume(Resources& resources, const std::shared_ptr<const Volume>& volume) {
  if (is_in_bricks(resources, volume))
    brick_atlas(resources, volume);
  else
    whole_volume(resources, volume);
}

void bind_volume(Resources& resources, const std::shared_ptr<const Volume>& volume,
                 const std::shared_ptr<const BrickSet>& bricks, VolumeUnits units, GLuint program) {
  gl::set(program, "volume", int(units.volume));
  if (!bricks) {
    const WholeVolume& whole = whole_volume(resources, volume);
    glBindTextureUnit(units.volume, whole.texture.id());
    return gl::set(program, "texel_scale", whole.scale);
  }
  BrickAtlas& atlas = brick_atlas(resources, volume);
  resources.held.with_room([&] { atlas.require(bricks, resources.atlas_bytes); });
  resources.held.recount<std::unique_ptr<BrickAtlas>>(AtlasKey(volume), atlas.byte_count());
  glBindTextureUnit(units.volume, atlas.texture());
  glBindTextureUnit(units.brick_table, atlas.table());
  gl::set(program, "brick_table", int(units.brick_table));
  gl::set(program, "texel_scale", atlas.scale());
  const glm::ivec3 points = volume->grid.dims;
  glProgramUniform3i(program, glGetUniformLocation(program, "grid_points"), points.x, points.y, points.z);
}

GLuint empty_cells_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume, int radius) {
  return held
      .get(EmptyCellsKey(volume, radius), volume->grid.point_count(),
           [&] { return upload_empty_cells(*volume, radius); })
      .id();
}

}  // namespace crest
