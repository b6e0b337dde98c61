#include "render/resources/brick_atlas.h"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/vec4.hpp>
#include <limits>
#include <numeric>

#include "render/gl/errors.h"
#include "render/gl/texture.h"

namespace crest {
namespace {

constexpr std::size_t points_of_a_brick = std::size_t(brick_points) * brick_points * brick_points;

/// Rows of the grid's points; what lies beyond the grid stays as it is, and is not read.
void copy_brick(const TexelFormat& format, glm::ivec3 dims, glm::ivec3 brick, std::byte* out) {
  const glm::ivec3 first = brick * brick_cells, size = glm::min(dims - first, glm::ivec3(brick_points));
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y) {
      const std::size_t row = std::size_t(first.y + y) + std::size_t(dims.y) * std::size_t(first.z + z);
      format.write(std::size_t(first.x) + std::size_t(dims.x) * row, std::size_t(size.x),
                   out + std::size_t(brick_points * (y + brick_points * z)) * format.bytes);
    }
}

/// As a sampler has it.
float texel_of(const TexelFormat& format, std::size_t point) {
  if (format.type == GL_FLOAT) {
    float texel = 0;
    format.write(point, 1, reinterpret_cast<std::byte*>(&texel));
    return texel;
  }
  std::uint16_t texel = 0;
  format.write(point, 1, reinterpret_cast<std::byte*>(&texel));
  return float(texel) / float(std::numeric_limits<std::uint16_t>::max());
}

/// About as many on each axis as hold `count`, at most `most` on each.
glm::ivec3 arranged(std::size_t count, int most) {
  const auto through = [](std::size_t a, std::size_t b) { return (a + b - 1) / b; };
  const int x = std::clamp(int(std::ceil(std::cbrt(double(count)))), 1, most);
  const int y = std::clamp(int(std::ceil(std::sqrt(double(through(count, std::size_t(x)))))), 1, most);
  return {x, y, int(through(count, std::size_t(x) * std::size_t(y)))};
}

}  // namespace

bool takes_texture(glm::ivec3 size, GLenum internal_format) {
  GLint largest = 0, width = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
  if (std::max({size.x, size.y, size.z}) > largest) return false;
  const bool is_integer = internal_format == GL_RGBA32UI;
  gl::forget_errors();
  glTexImage3D(GL_PROXY_TEXTURE_3D, 0, GLint(internal_format), size.x, size.y, size.z, 0,
               is_integer ? GL_RGBA_INTEGER : GL_RED, is_integer ? GL_UNSIGNED_INT : GL_FLOAT, nullptr);
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_WIDTH, &width);
  return glGetError() == GL_NO_ERROR && width == size.x;
}

BrickAtlas::BrickAtlas(const Volume& volume, TexelFormat format)
    : format_(std::move(format)),
      points_(volume.grid.dims),
      dims_(brick_dims(volume.grid)),
      table_(gl::make_texture(GL_TEXTURE_3D, GL_NEAREST)),
      slot_of_(brick_count(volume.grid), -1),
      some_texel_(slot_of_.size()) {
  if (!takes_texture(dims_, GL_RGBA32UI))
    throw gl::NoRoom(fmt::format(
        "{}: {}x{}x{} points are too many for this graphics driver: open a part of them (?stride=2, ?crop=)",
        volume.name, points_.x, points_.y, points_.z));
  glTextureStorage3D(table_.id(), 1, GL_RGBA32UI, dims_.x, dims_.y, dims_.z);
  for (std::size_t brick = 0; brick < some_texel_.size(); ++brick) {
    const glm::ivec3 point = brick_at(int(brick)) * brick_cells;
    some_texel_[brick] = texel_of(format_, volume.index(point.x, point.y, point.z));
  }
}

std::size_t BrickAtlas::byte_count() const { return brick_in_.size() * points_of_a_brick * format_.bytes; }

glm::ivec3 BrickAtlas::brick_at(int index) const {
  return {index % dims_.x, index / dims_.x % dims_.y, index / dims_.x / dims_.y};
}

glm::ivec3 BrickAtlas::place_of(std::size_t slot) const {
  const int index = int(slot);
  return {index % slots_.x, index / slots_.x % slots_.y, index / slots_.x / slots_.y};
}

void BrickAtlas::require(const std::shared_ptr<const BrickSet>& bricks, std::size_t most_bytes) {
  if (bricks == last_) return;
  ++round_;
  std::vector<int> missing;
  for (std::size_t brick = 0; brick < bricks->size(); ++brick) {
    if (!(*bricks)[brick]) continue;
    if (slot_of_[brick] >= 0)
      last_round_[std::size_t(slot_of_[brick])] = round_;
    else
      missing.push_back(int(brick));
  }
  if (!missing.empty() || !texture_) {
    if (needs_room(*bricks, missing.size())) {
      make_room(*bricks, missing.size(), most_bytes);
      return require(bricks, most_bytes);
    }
    upload(missing);
  }
  last_ = bricks;
}

/// Those of the last pictures, which may be views and slices drawn in turn.
std::size_t BrickAtlas::recent() const {
  constexpr std::uint64_t recent_rounds = 8;
  return std::size_t(std::ranges::count_if(
      last_round_, [&](std::uint64_t round) { return round > 0 && round + recent_rounds >= round_; }));
}

bool BrickAtlas::needs_room(const BrickSet& bricks, std::size_t missing) const {
  const std::size_t slots = brick_in_.size();
  return !texture_ || size_of(bricks) > slots || (!is_full_ && recent() + missing > slots);
}

/// For all that were drawn lately, and a quarter more, if there is room: edits bring some, and take others
/// away.
void BrickAtlas::make_room(const BrickSet& bricks, std::size_t missing, std::size_t most_bytes) {
  const std::size_t least = std::max<std::size_t>(size_of(bricks), 1),
                    wanted = std::max(least, recent() + missing);
  constexpr int most_slots = 255;  // that the table's texels can tell
  GLint largest = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
  const int most = std::min(largest / brick_points, most_slots);
  texture_ = {};
  brick_in_.clear();
  last_round_.clear();
  last_ = nullptr;
  std::ranges::fill(slot_of_, -1);
  for (const std::size_t count : {wanted + wanted / 4, wanted, least}) {
    is_full_ = count < wanted;  // what is drawn in turn takes each other's place
    slots_ = arranged(count, most);
    const glm::ivec3 size = slots_ * brick_points;
    const double bytes = double(size.x) * double(size.y) * double(size.z) * double(format_.bytes);
    if (slots_.z > most || bytes > double(most_bytes) || !takes_texture(size, format_.internal)) continue;
    gl::TextureHandle texture = gl::make_texture(GL_TEXTURE_3D, GL_LINEAR);
    glTextureStorage3D(texture.id(), 1, format_.internal, size.x, size.y, size.z);
    if (glGetError() != GL_NO_ERROR) continue;
    glClearTexImage(texture.id(), 0, GL_RED, format_.type, nullptr);  // the filter may look beside a brick
    texture_ = std::move(texture);
    brick_in_.assign(std::size_t(slots_.x) * std::size_t(slots_.y) * std::size_t(slots_.z), -1);
    last_round_.assign(brick_in_.size(), 0);
    return;
  }
  throw gl::NoRoom(fmt::format(
      "{:.3g} GB of the volume show, which is more than the graphics device has room for: let the transfer "
      "function show less, or open every 2nd point (?stride=2)",
      double(least * points_of_a_brick * format_.bytes) / 1e9));
}

/// Into the slots that were asked for longest ago, the free ones first.
void BrickAtlas::upload(const std::vector<int>& missing) {
  std::vector<std::size_t> slots(brick_in_.size());
  std::iota(slots.begin(), slots.end(), std::size_t(0));
  std::ranges::stable_sort(slots, {}, [&](std::size_t slot) { return last_round_[slot]; });
  constexpr std::size_t batch = 256;
  const std::size_t bytes = points_of_a_brick * format_.bytes;
  std::vector<std::byte> room(std::min(batch, missing.size()) * bytes);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (std::size_t begin = 0; begin < missing.size(); begin += batch) {
    const std::size_t count = std::min(batch, missing.size() - begin);
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
      const int brick = missing[begin + i];
      copy_brick(format_, points_, brick_at(brick), room.data() + i * bytes);
    });
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t slot = slots[begin + i];
      const glm::ivec3 at = place_of(slot) * brick_points;
      glTextureSubImage3D(texture_.id(), 0, at.x, at.y, at.z, brick_points, brick_points, brick_points,
                          GL_RED, format_.type, room.data() + i * bytes);
      if (brick_in_[slot] >= 0) slot_of_[std::size_t(brick_in_[slot])] = -1;
      brick_in_[slot] = missing[begin + i];
      slot_of_[std::size_t(missing[begin + i])] = int(slot);
      last_round_[slot] = round_;
    }
  }
  uploads_ += int(missing.size());
  gl::require_no_error("taking a volume's bricks");
  write_table();
}

void BrickAtlas::write_table() {
  constexpr std::uint32_t not_held = 0xffffffff;
  std::vector<glm::uvec4> texels(slot_of_.size());
  for (std::size_t brick = 0; brick < texels.size(); ++brick) {
    const int slot = slot_of_[brick];
    const glm::uvec3 place = slot < 0 ? glm::uvec3(not_held) : glm::uvec3(place_of(std::size_t(slot)));
    texels[brick] = {place, std::bit_cast<std::uint32_t>(some_texel_[brick])};
  }
  glTextureSubImage3D(table_.id(), 0, 0, 0, 0, dims_.x, dims_.y, dims_.z, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                      texels.data());
}

}  // namespace crest
