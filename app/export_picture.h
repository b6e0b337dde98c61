#pragma once

#include <memory>
#include <optional>

#include "presets/exchange/exporters.h"
#include "render/gl/display_texture.h"
#include "render/renderer.h"
#include "ui/studio.h"

namespace crest {

/// What the studio exports: the preset in the volume's units, with the camera of the view.
ExportInput export_input(const Preset& preset, const Volume* volume, int rows,
                         const std::filesystem::path& output, std::string_view extension,
                         glm::ivec2 size = {1024, 1024});

/// Writes all files of an export. Throws Error.
void write_export(const Exported& exported, const ExportInput& input, const std::filesystem::path& output);

/// The path of one of its files.
std::filesystem::path path_of(const std::filesystem::path& output, const std::string& stem,
                              const ExportFile& file);

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
    ExportChoice choice;
    bool operator==(const Shown&) const = default;
  };
  std::optional<Shown> shown_;
  ExportPicture picture_;
  gl::TextureHandle texture_;
};

}  // namespace crest
