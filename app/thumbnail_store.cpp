#include "app/thumbnail_store.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <algorithm>
#include <utility>
#include <vector>

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

void ThumbnailStore::begin_frame(std::size_t most) {
  std::vector<std::uint64_t> frames;
  if (textures_.size() > most) {
    for (const auto& [key, held] : textures_) frames.push_back(held.last_frame);
    std::ranges::nth_element(frames, frames.begin() + std::ptrdiff_t(frames.size() - most - 1));
    const std::uint64_t newest_to_go = std::min(frames[frames.size() - most - 1], frame_ - 1);
    std::erase_if(textures_, [&](const auto& entry) { return entry.second.last_frame <= newest_to_go; });
  }
  std::erase_if(replaced_, [&](const Held& held) { return held.last_frame < frame_; });
  ++frame_;
}

std::uintptr_t ThumbnailStore::texture(const std::string& key) {
  const auto [found, is_new] = textures_.try_emplace(key);
  Held& held = found->second;
  held.last_frame = frame_;
  if (is_new && !folder_.empty())
    if (const auto png = read_cached(file_of(key), most_bytes))
      if (const auto thumbnail = thumbnail_from_png(*png)) held.texture = upload(*thumbnail);
  return held.texture.id();
}

void ThumbnailStore::show(const std::string& key, const Thumbnail& thumbnail) {
  Held shown{upload(thumbnail), frame_};
  Held& held = textures_[key];
  std::swap(held, shown);
  if (shown.texture) replaced_.push_back(std::move(shown));
}

void ThumbnailStore::write(const std::string& key, const Thumbnail& thumbnail) const {
  if (!folder_.empty()) write_cached(file_of(key), png_of(thumbnail), most_bytes);
}

}  // namespace crest
