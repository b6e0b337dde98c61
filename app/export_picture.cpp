#include "app/export_picture.h"

#include "app/export_preview.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "render/gl/texture.h"
#include "render/scene/camera.h"
#include "render/volume/export_volume.h"

namespace crest {
namespace {

constexpr glm::ivec2 tile{320, 320};

/// Into the one texture: the frame that is being drawn names it already.
void upload(gl::TextureHandle& texture, const Image& image) {
  if (!texture) {
    texture = gl::make_texture(GL_TEXTURE_2D, GL_LINEAR);
    glTextureStorage2D(texture.id(), 1, GL_RGBA8, image.size.x, image.size.y);
  }
  glTextureSubImage2D(texture.id(), 0, 0, 0, image.size.x, image.size.y, GL_RGBA, GL_FLOAT,
                      image.pixels.data());
}

}  // namespace

std::filesystem::path path_of(const std::filesystem::path& output, const std::string& stem,
                              const ExportFile& file) {
  return file.suffix.empty() ? output : output.parent_path() / (stem + file.suffix);
}

ExportInput export_input(const Preset& preset, const Volume* volume, int rows,
                         const std::filesystem::path& output, std::string_view extension, glm::ivec2 size) {
  ExportInput input;
  input.rows = rows;
  input.size = size;
  const std::string name = output.filename().string();
  input.stem =
      name.ends_with(extension) ? name.substr(0, name.size() - extension.size()) : output.stem().string();
  input.name = preset.name.empty() ? input.stem : preset.name;
  input.preset = preset;
  if (volume) {
    input.volume = export_volume(*volume);
    input.preset.camera = camera_of(preset, volume->grid, aspect_of(input.size));
  }
  input.preset = ready_for_export(input.preset, input.volume);
  return input;
}

void write_export(const Exported& exported, const ExportInput& input, const std::filesystem::path& output) {
  // What others name is there before what names it
  for (auto file = exported.files.rbegin(); file != exported.files.rend(); ++file)
    write_file_atomically(path_of(output, input.stem, *file), file->content);
}

void ExportPictureMaker::update(Renderer& renderer, const std::shared_ptr<const Volume>& volume,
                                const Preset& preset, ExportChoice choice) {
  const Shown wanted{volume, preset, choice};
  if (shown_ == wanted) return;
  shown_ = wanted;
  picture_ = {};
  const Exporter& exporter = exporters()[std::size_t(choice.format)];
  ExportInput input = export_input(preset, volume.get(), choice.rows, "preset", exporter.extension, tile);
  const Camera camera = camera_of(preset, volume->grid, aspect_of(tile));
  const ExportPreview preview = preview_export(renderer, exporter, input, volume, camera, tile);
  const Image picture = picture_of(preview, exporter.name, preset.rendering.background);
  upload(texture_, picture);
  picture_ = {texture_.id(), picture.size, preview.rmse, preview.max, preview.share};
}

ExportPicture ExportPictureMaker::picture() const { return shown_ ? picture_ : ExportPicture{}; }

}  // namespace crest
