#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/files/image.h"

namespace crest {

inline constexpr glm::ivec2 thumbnail_size{208, 156};

/// A small opaque picture of thumbnail_size, 8-bit RGB, row 0 at the top.
struct Thumbnail {
  std::vector<std::uint8_t> rgb =
      std::vector<std::uint8_t>(std::size_t(3 * thumbnail_size.x * thumbnail_size.y));
  bool operator==(const Thumbnail&) const = default;
};

/// The middle of an RGBA picture in the thumbnail's shape, shrunk by the mean of the pixels under each of its
/// own; of smaller pictures, the nearest pixel.
Thumbnail shrunk(std::span<const glm::u8vec4> rgba, glm::ivec2 size);

/// A picture of thumbnail_size, over a background.
Thumbnail thumbnail_of(const Image& image, glm::vec3 background);

std::string png_of(const Thumbnail& thumbnail);
/// Nothing where it is no such PNG, or of another size.
std::optional<Thumbnail> thumbnail_from_png(std::string_view png);

}  // namespace crest
