#pragma once

#include <memory>
#include <optional>

#include "render/files/image.h"
#include "render/gl/handle.h"
#include "render/renderer.h"
#include "ui/studio.h"

namespace crest {

/// Keeps the picture of the window for exports, and draws it again when what it shows changes.
class ExportPictureMaker {
 public:
  /// Draws in `renderer`, at once.
  void update(Renderer& renderer, const std::shared_ptr<const Volume>& volume, const Preset& preset,
              ExportChoice choice);
  void clear() { shown_.reset(); }
  ExportPicture picture() const;

 private:
  struct Shown {
    std::shared_ptr<const Volume> volume;
    Preset preset;
    Image here;  ///< Crest's own picture, which no choice changes
    ExportChoice choice;
  };
  std::optional<Shown> shown_;
  ExportPicture picture_;
  gl::TextureHandle texture_;
};

}  // namespace crest
