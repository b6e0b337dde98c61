#pragma once

#include <filesystem>
#include <optional>

#include "app/background_task.h"
#include "render/files/raw_slice.h"
#include "render/gl/handle.h"
#include "ui/studio.h"

namespace crest {

/// The middle slice of a file of raw voxels as a texture, read beside the window while somebody types how the
/// voxels lie. A GL 4.5 context must be current throughout.
class RawPreview {
 public:
  RawPreview();
  /// What is wanted now; reading begins where it differs from what was wanted before.
  void want(const std::filesystem::path& path, const RawLayout& layout);
  /// Nothing is wanted any more. The texture stays: the frame that is being drawn may name it.
  void forget();
  /// Takes what was read, before the panels are drawn.
  void take();
  const RawPicture& picture() const { return picture_; }
  bool is_busy() const { return task_.is_running(); }
  bool has_news() const { return task_.has_news(); }

 private:
  struct Subject {
    std::filesystem::path path;
    RawLayout layout;
    bool operator==(const Subject&) const = default;
  };
  std::optional<Subject> wanted_;
  RawPicture picture_;
  gl::TextureHandle texture_;
  BackgroundTask<Subject, RawSlice> task_;
};

}  // namespace crest
