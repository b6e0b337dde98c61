#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "app/thumbnail.h"
#include "render/gl/handle.h"

namespace crest {

/// Thumbnails by a key - a text that says what they show - as textures, kept in files of the cache folder. A
/// GL 4.5 context must be current throughout.
class ThumbnailStore {
 public:
  /// An empty folder: they live as long as the program.
  explicit ThumbnailStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// An ImTextureID, row 0 at the top; 0 where there is none.
  std::uintptr_t texture(const std::string& key);
  /// Shows it from now on; write() keeps it.
  void show(const std::string& key, const Thumbnail& thumbnail);
  /// Into its file, for the next start. Any thread may call it, without a context.
  void write(const std::string& key, const Thumbnail& thumbnail) const;

 private:
  std::filesystem::path file_of(const std::string& key) const;

  std::filesystem::path folder_;
  std::map<std::string, gl::TextureHandle> textures_;  ///< empty where a key has none
};

/// What a texture of 8-bit RGBA shows.
Thumbnail thumbnail_of_texture(GLuint texture);

}  // namespace crest
