#include "app/thumbnail_store.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <utility>

#include "render/files/folder_cache.h"
#include "render/gl/texture.h"

namespace crest {
namespace {

constexpr std::uintmax_t most_bytes = 16 << 20;  // some 500 pictures

gl::TextureHandle upload(const Thumbnail& thumbnail) {
  gl::TextureHandle texture = gl::make_texture(GL_TEXTURE_2D, GL_LINEAR);
  const auto [width, height] = std::pair(thumbnail_size.x, thumbnail_size.y);
  glTextureStorage2D(texture.id(), 1, GL_RGB8, width, height);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(texture.id(), 0, 0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, thumbnail.rgb.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  return texture;
}

}  // namespace

std::filesystem::path ThumbnailStore::file_of(const std::string& key) const {
  return folder_ / fmt::format("{:016x}.png", XXH64(key.data(), key.size(), 0));
}

std::uintptr_t ThumbnailStore::texture(const std::string& key) {
  const auto [found, is_new] = textures_.try_emplace(key);
  if (is_new && !folder_.empty())
    if (const auto png = read_cached(file_of(key), most_bytes))
      if (const auto thumbnail = thumbnail_from_png(*png)) found->second = upload(*thumbnail);
  return found->second.id();
}

void ThumbnailStore::show(const std::string& key, const Thumbnail& thumbnail) {
  textures_.insert_or_assign(key, upload(thumbnail));
}

void ThumbnailStore::write(const std::string& key, const Thumbnail& thumbnail) const {
  if (!folder_.empty()) write_cached(file_of(key), png_of(thumbnail), most_bytes);
}

Thumbnail thumbnail_of_texture(GLuint texture) {
  glm::ivec2 size{0};
  glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_WIDTH, &size.x);
  glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_HEIGHT, &size.y);
  std::vector<std::uint8_t> rgba(4 * std::size_t(size.x) * std::size_t(size.y));
  glGetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(rgba.size()), rgba.data());
  return shrunk(rgba, size);
}

}  // namespace crest
