#include "app/export_picture.h"

#include <utility>

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

/// A picture of the tile's size, on its way.
gl::PendingRead begin_picture(Renderer& renderer, const Scene& scene, const Camera& camera) {
  gl::RenderTarget target(tile, false);
  renderer.draw_at_once(scene, camera, target);
  return {target, gl::PendingRead::What::color};
}

Image image_of(const gl::PendingRead& read) { return {read.size(), read.color()}; }

}  // namespace

void ExportPictureMaker::draw(Renderer& renderer) {
  const Exporter& exporter = exporters()[std::size_t(shown_->choice.format)];
  const ExportInput input =
      export_input(shown_->preset, shown_->volume.get(), shown_->choice.rows, "preset", tile);
  const auto begin = [&](const Preset& preset) {
    return begin_picture(renderer, make_scene(shown_->volume, preset), *input.preset.camera);
  };
  std::optional<gl::PendingRead> here;
  if (shown_->here.pixels.empty()) here = begin(input.preset);
  drawing_.emplace(Drawing{std::move(here), begin(exporter.as_drawn(input))});
}

void ExportPictureMaker::take() {
  const Drawing done = *std::exchange(drawing_, {});  // what fails is not read again
  if (done.here) shown_->here = image_of(*done.here);
  const ExportPreview preview = compare_export(shown_->here, image_of(done.there));
  const Exporter& exporter = exporters()[std::size_t(shown_->choice.format)];
  const Image picture = picture_of(preview, exporter.name, shown_->preset.rendering.background);
  upload(texture_, picture);
  picture_ = {texture_.id(), picture.size, preview.rmse, preview.max, preview.share};
}

void ExportPictureMaker::update(Renderer& renderer, const std::shared_ptr<const Volume>& volume,
                                const Preset& preset, ExportChoice choice) {
  const bool is_same_scene = shown_ && shown_->volume == volume && shown_->preset == preset;
  if (!is_same_scene || shown_->choice != choice) {
    picture_ = {};
    drawing_.reset();
    if (!is_same_scene) shown_ = Shown{volume, preset, {}, choice};
    shown_->choice = choice;
    draw(renderer);
  }
  if (drawing_ && drawing_->is_over()) take();
}

ExportPicture ExportPictureMaker::picture() const { return shown_ ? picture_ : ExportPicture{}; }

}  // namespace crest
