#include "app/slice_pictures.h"

namespace crest {
namespace {

/// As far as slices go.
bool is_same(const Scene& a, const Scene& b) {
  return a.volume == b.volume && a.tf == b.tf && dvr_filter(a.rendering) == dvr_filter(b.rendering) &&
         root_filter(a.rendering) == root_filter(b.rendering);
}

}  // namespace

void SlicePictures::update(Resources& resources, const Scene& scene, const SlicesWanted& wanted) {
  for (int axis = 0; axis < slice_count; ++axis)
    if (const glm::ivec2 size = wanted.pixels[std::size_t(axis)]; size.x > 0 && size.y > 0)
      draw(resources, scene, pictures_[std::size_t(axis)], {axis, wanted.cursor[axis]}, size);
}

void SlicePictures::draw(Resources& resources, const Scene& scene, Picture& picture, const Slice& slice,
                         glm::ivec2 size) {
  const bool has_size = picture.display && picture.display->size() == size;
  picture.last.reset();
  if (has_size && picture.scene && is_same(*picture.scene, scene) && picture.slice == slice) return;
  if (!renderer_) renderer_.emplace();
  if (!has_size) {
    picture.last = std::move(picture.display);
    picture.display = std::make_unique<gl::DisplayTexture>(size);
  }
  picture.scene.reset();
  renderer_->draw(resources, scene, slice, *picture.display);
  picture.scene = scene;
  picture.slice = slice;
}

std::array<std::uintptr_t, slice_count> SlicePictures::textures() const {
  std::array<std::uintptr_t, slice_count> textures{};
  for (std::size_t i = 0; i < slice_count; ++i)
    if (pictures_[i].display) textures[i] = pictures_[i].display->texture();
  return textures;
}

}  // namespace crest
