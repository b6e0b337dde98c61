#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/thumbnail.h"
#include "render/gl/handle.h"

namespace crest {

/// Thumbnails by a key - a text that says what they show - as textures, kept in files of the cache folder.
/// Above a number of textures those go that no frame asked for lately. A GL 4.5 context must be current
/// throughout.
class ThumbnailStore {
 public:
  /// An empty folder: they live as long as the program.
  explicit ThumbnailStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Before a frame. What the last one asked for stays, also where it is more than `most`.
  void begin_frame(std::size_t most = 32);
  std::size_t count() const { return textures_.size(); }
  /// An ImTextureID, row 0 at the top; 0 where there is none. It lives through this frame and the next.
  std::uintptr_t texture(const std::string& key);
  /// Shows it from now on; write() keeps it.
  void show(const std::string& key, const Thumbnail& thumbnail);
  /// Into its file, for the next start. Any thread may call it, without a context.
  void write(const std::string& key, const Thumbnail& thumbnail) const;

 private:
  std::filesystem::path file_of(const std::string& key) const;

  std::filesystem::path folder_;
  struct Held {
    gl::TextureHandle texture;  ///< empty where the key has none
    std::uint64_t last_frame = 0;
  };
  std::map<std::string, Held> textures_;
  std::vector<Held> replaced_;  ///< which a frame may still name
  std::uint64_t frame_ = 1;
};

}  // namespace crest
