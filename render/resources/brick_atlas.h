#pragma once

#include <memory>
#include <vector>

#include "render/gl/handle.h"
#include "render/resources/texel_format.h"
#include "render/volume/bricks.h"

namespace crest {

/// Those bricks of a volume that pictures read, side by side in one texture, and where each of them is: for
/// volumes that are too large for a texture of their own, of which little shows. A brick stays until its
/// place is needed for another one. The context must be current whenever it is used.
class BrickAtlas {
 public:
  /// `format` is the volume's.
  BrickAtlas(const Volume& volume, TexelFormat format);

  /// Makes these bricks resident. Throws gl::NoRoom where they are more than the driver has room for, or take
  /// more than `most_bytes`.
  void require(const std::shared_ptr<const BrickSet>& bricks, std::size_t most_bytes);

  GLuint texture() const { return texture_.id(); }  ///< a brick's points each, at its slot
  /// RGBA32UI, a texel a brick: its slot on each axis; where it is not resident the greatest number, and
  /// behind it the bits of one of its texels, as a sampler has it.
  GLuint table() const { return table_.id(); }
  float scale() const { return format_.scale; }
  std::size_t byte_count() const;           ///< of the texture
  int uploads() const { return uploads_; }  ///< of bricks, in all

 private:
  std::size_t recent() const;
  bool needs_room(const BrickSet& bricks, std::size_t missing) const;
  void make_room(const BrickSet& bricks, std::size_t missing, std::size_t most_bytes);
  void upload(const std::vector<int>& missing);
  void write_table();
  glm::ivec3 brick_at(int index) const;
  glm::ivec3 place_of(std::size_t slot) const;

  TexelFormat format_;
  glm::ivec3 points_, dims_;  ///< of the volume: its points, and its bricks
  glm::ivec3 slots_{0};       ///< of the texture
  gl::TextureHandle texture_, table_;
  std::vector<int> brick_in_;              ///< a slot each; -1 where it is free
  std::vector<int> slot_of_;               ///< a brick each; -1 where it is not resident
  std::vector<float> some_texel_;          ///< a brick each
  std::vector<std::uint64_t> last_round_;  ///< a slot each: when it was last asked for
  std::uint64_t round_ = 0;
  bool is_full_ = false;                  ///< there is no room for more than one picture's
  std::shared_ptr<const BrickSet> last_;  ///< what was asked for last
  int uploads_ = 0;
};

/// Whether the driver takes a 3D texture of this size.
bool takes_texture(glm::ivec3 size, GLenum internal_format);

}  // namespace crest
