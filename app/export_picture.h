#pragma once

#include <memory>
#include <optional>

#include "render/files/image.h"
#include "render/gl/handle.h"
#include "render/gl/pending_read.h"
#include "render/renderer.h"
#include "ui/studio.h"

namespace crest {

/// Keeps the picture of the window for exports, and draws it again when what it shows changes. It is there
/// when the device is through with it.
class ExportPictureMaker {
 public:
  /// Draws in `renderer`, without waiting. To be called each frame.
  void update(Renderer& renderer, const std::shared_ptr<const Volume>& volume, const Preset& preset,
              ExportChoice choice);
  void clear() { drawing_.reset(), shown_.reset(); }
  bool is_busy() const { return drawing_.has_value(); }
  ExportPicture picture() const;

 private:
  struct Shown {
    std::shared_ptr<const Volume> volume;
    Preset preset;
    Image here;  ///< Crest's own picture, which no choice changes
    ExportChoice choice;
  };
  /// On their way: the target's picture, and Crest's own where it is not known.
  struct Drawing {
    std::optional<gl::PendingRead> here;
    gl::PendingRead there;
    bool is_over() const { return there.is_over(); }  // the later one
  };
  void draw(Renderer& renderer);
  void take();

  std::optional<Shown> shown_;
  std::optional<Drawing> drawing_;
  ExportPicture picture_;
  gl::TextureHandle texture_;
};

}  // namespace crest
