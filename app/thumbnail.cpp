#include "app/thumbnail.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <memory>

namespace crest {
namespace {

constexpr int width = thumbnail_size.x, height = thumbnail_size.y;

/// The pixels [first, last) that lie under pixel `i` of `count`, when `from` .. `from + length` is shrunk to
/// them.
std::pair<int, int> under(int i, int count, int from, int length) {
  const int first = from + int(std::int64_t(length) * i / count);
  const int last = from + int(std::int64_t(length) * (i + 1) / count);
  return {first, std::max(last, first + 1)};
}

}  // namespace

Thumbnail shrunk(std::span<const glm::u8vec4> rgba, glm::ivec2 size) {
  Thumbnail small;
  if (size.x < 1 || size.y < 1) return small;
  const glm::ivec2 part{std::clamp(size.y * width / height, 1, size.x),
                        std::clamp(size.x * height / width, 1, size.y)};
  const glm::ivec2 corner = (size - part) / 2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto [left, right] = under(x, width, corner.x, part.x);
      const auto [top, bottom] = under(y, height, corner.y, part.y);
      std::uint64_t sum[3] = {};
      for (int v = top; v < bottom; ++v)
        for (int u = left; u < right; ++u)
          for (int c = 0; c < 3; ++c)
            sum[c] += rgba[std::size_t(v) * std::size_t(size.x) + std::size_t(u)][c];
      const auto count = std::uint64_t(right - left) * std::uint64_t(bottom - top);
      for (int c = 0; c < 3; ++c)
        small.rgb[std::size_t(3 * (y * width + x) + c)] = std::uint8_t((sum[c] + count / 2) / count);
    }
  return small;
}

Thumbnail thumbnail_of(const Image& image, glm::vec3 background) {
  Thumbnail thumbnail;
  for (std::size_t i = 0; i < std::min(image.pixels.size(), thumbnail.rgb.size() / 3); ++i) {
    const glm::vec4& pixel = image.pixels[i];
    for (int c = 0; c < 3; ++c) {
      const float value = pixel[c] + (1 - pixel.a) * background[c];
      thumbnail.rgb[3 * i + std::size_t(c)] = std::uint8_t(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
    }
  }
  return thumbnail;
}

std::string png_of(const Thumbnail& thumbnail) {
  std::string png;
  const auto append = [](void* to, void* data, int bytes) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), std::size_t(bytes));
  };
  stbi_write_png_to_func(append, &png, width, height, 3, thumbnail.rgb.data(), 3 * width);
  return png;
}

std::optional<Thumbnail> thumbnail_from_png(std::string_view png) {
  int x = 0, y = 0, channels = 0;
  const auto* bytes = reinterpret_cast<const stbi_uc*>(png.data());
  if (png.size() > 1 << 20 || !stbi_info_from_memory(bytes, int(png.size()), &x, &y, &channels))
    return std::nullopt;
  if (x != width || y != height) return std::nullopt;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes, int(png.size()), &x, &y, &channels, 3), stbi_image_free);
  if (!pixels) return std::nullopt;
  Thumbnail thumbnail;
  std::copy_n(pixels.get(), thumbnail.rgb.size(), thumbnail.rgb.begin());
  return thumbnail;
}

}  // namespace crest
