#include "render/resources/volume_texture.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <span>

#include "render/classify/stored_units.h"
#include "render/gl/errors.h"
#include "render/gl/filter_weights.h"
#include "render/gl/texture.h"
#include "render/gl/uniforms.h"
#include "render/resources/volume_key.h"
#include "render/volume/empty_cells.h"
#include "render/volume/whole_values.h"

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

struct SixteenBitsKey {
  bool operator==(const SixteenBitsKey&) const = default;
};

/// Whether the texture unit filters 16-bit texels as well as floats.
bool filters_16_bits(KeyedCache& held) {
  return held.get(SixteenBitsKey(), 0, [] {
    constexpr double rounding = 0x1p-16;
    return gl::measure_weight_error(GL_R16) <= gl::measure_weight_error(GL_R32F) + rounding;
  });
}

/// `fill` writes the points from `first` on: a slab at a time, since the whole would take as much again.
template <class Value, class Fill>
gl::TextureHandle upload_slabs(const Volume& volume, GLenum internal_format, GLenum type, const Fill& fill) {
  constexpr std::size_t slab_points = std::size_t(1) << 22;
  const glm::ivec3 dims = volume.grid.dims;
  gl::TextureHandle texture = make_3d(dims, internal_format, GL_LINEAR);
  require_room(dims);
  const std::size_t slice = std::size_t(dims.x) * std::size_t(dims.y);
  const int depth = int(std::clamp<std::size_t>(slab_points / slice, 1, std::size_t(dims.z)));
  std::vector<Value> slab(slice * std::size_t(depth));
  for (int z = 0; z < dims.z; z += depth) {
    const int slices = std::min(depth, dims.z - z);
    fill(slice * std::size_t(z), std::span(slab).first(slice * std::size_t(slices)));
    glTextureSubImage3D(texture.id(), 0, 0, 0, z, dims.x, dims.y, slices, GL_RED, type, slab.data());
    require_room(dims);
  }
  return texture;
}

/// Spread over the 16 bits by a power of two, so that a filter of few digits loses as little as may be.
VolumeTexture upload_whole(const Volume& volume, const WholeValues& whole) {
  constexpr int most = std::numeric_limits<std::uint16_t>::max();
  int spread = 1;
  while (2 * spread * std::max(whole.most, 1) <= most) spread *= 2;
  return {upload_slabs<std::uint16_t>(volume, GL_R16, GL_UNSIGNED_SHORT,
                                      [&](std::size_t first, std::span<std::uint16_t> out) {
                                        write_steps(volume, whole, first, spread, out);
                                      }),
          float(most) / float(spread)};
}

VolumeTexture upload_volume(KeyedCache& held, const Volume& volume) {
  const StoredUnits units = stored_units(volume);
  const glm::ivec3 dims = volume.grid.dims;
  GLint largest = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
  if (std::max({dims.x, dims.y, dims.z}) > largest)
    throw Error(fmt::format("{}: {}x{}x{} points are too many for this graphics driver: at most {} an axis",
                            volume.name, dims.x, dims.y, dims.z, largest));
  if (volume.has_empty_cells()) {
    std::vector<float> values = finite_values(volume);
    for (float& value : values) value = units.stored(value);
    return {upload_3d(dims, GL_R32F, GL_RED, GL_FLOAT, values.data(), GL_LINEAR)};
  }
  if (const auto whole = whole_values(volume); whole && filters_16_bits(held))
    return upload_whole(volume, *whole);
  return {upload_slabs<float>(volume, GL_R32F, GL_FLOAT, [&](std::size_t first, std::span<float> out) {
    std::vector<float> room;
    const std::span<const float> values = volume.values.part(first, out.size(), room);
    std::ranges::transform(values, out.begin(), [&](float value) { return units.stored(value); });
  })};
}

gl::TextureHandle upload_empty_cells(const Volume& volume, int radius) {
  return upload_3d(volume.grid.dims - 1, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                   find_empty_cells(volume, radius).data(), GL_NEAREST);
}

}  // namespace

const VolumeTexture& volume_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume) {
  return held.get(ValuesKey(volume), volume->grid.point_count() * texture_bytes_per_point(*volume),
                  [&] { return upload_volume(held, *volume); });
}

std::size_t texture_bytes_per_point(const Volume& volume) {
  return whole_values(volume) ? sizeof(std::uint16_t) : sizeof(float);
}

void bind_volume(KeyedCache& held, const std::shared_ptr<const Volume>& volume, GLuint unit, GLuint program) {
  const VolumeTexture& texture = volume_texture(held, volume);
  glBindTextureUnit(unit, texture.texture.id());
  gl::set(program, "volume", int(unit));
  gl::set(program, "texel_scale", texture.scale);
}

GLuint empty_cells_texture(KeyedCache& held, const std::shared_ptr<const Volume>& volume, int radius) {
  return held
      .get(EmptyCellsKey(volume, radius), volume->grid.point_count(),
           [&] { return upload_empty_cells(*volume, radius); })
      .id();
}

}  // namespace crest
