#include "app/export_picture.h"

#include "app/export_preview.h"
#include "render/gl/texture.h"
#include "render/scene/export_input.h"

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

void ExportPictureMaker::update(Renderer& renderer, const std::shared_ptr<const Volume>& volume,
                                const Preset& preset, ExportChoice choice) {
  const bool is_same_scene = shown_ && shown_->volume == volume && shown_->preset == preset;
  if (is_same_scene && shown_->choice == choice) return;
  picture_ = {};
  const Exporter& exporter = exporters()[std::size_t(choice.format)];
  const ExportInput input = export_input(preset, volume.get(), choice.rows, "preset", tile);
  const auto draw = [&](const Preset& p) {
    return draw_preset(renderer, p, volume, *input.preset.camera, tile);
  };
  if (!is_same_scene) shown_ = Shown{volume, preset, draw(input.preset), {}};
  shown_->choice = choice;
  const ExportPreview preview = compare_export(shown_->here, draw(exporter.as_drawn(input)));
  const Image picture = picture_of(preview, exporter.name, preset.rendering.background);
  upload(texture_, picture);
  picture_ = {texture_.id(), picture.size, preview.rmse, preview.max, preview.share};
}

ExportPicture ExportPictureMaker::picture() const { return shown_ ? picture_ : ExportPicture{}; }

}  // namespace crest
