#include "app/raw_preview.h"

#include <glm/vec3.hpp>
#include <vector>

#include "render/gl/texture.h"

namespace crest {
namespace {

constexpr int most_pixels = 512;  ///< on each axis
constexpr std::uint8_t beyond_end[3] = {92, 52, 44};

gl::TextureHandle upload(const RawSlice& slice) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * slice.grey.size());
  for (std::size_t i = 0; i < slice.grey.size(); ++i)
    for (const std::uint8_t there_is_none : beyond_end)
      rgb.push_back(slice.is_there[i] ? slice.grey[i] : there_is_none);
  gl::TextureHandle texture = gl::make_texture(GL_TEXTURE_2D, GL_NEAREST);
  glTextureStorage2D(texture.id(), 1, GL_RGB8, slice.size.x, slice.size.y);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(texture.id(), 0, 0, 0, slice.size.x, slice.size.y, GL_RGB, GL_UNSIGNED_BYTE,
                      rgb.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  return texture;
}

}  // namespace

RawPreview::RawPreview()
    : task_([](const Subject& subject, const std::stop_token&) {
        return std::optional(read_middle_slice(subject.path, subject.layout, most_pixels));
      }) {}

void RawPreview::want(const std::filesystem::path& path, const RawLayout& layout) {
  Subject subject{path, layout};
  subject.layout.spacing = glm::dvec3(1);  // no slice depends on it
  if (wanted_ == subject) return;
  wanted_ = subject;
  task_.start(std::move(subject));
}

void RawPreview::forget() {
  task_.stop();
  wanted_.reset();
  picture_ = {};
}

void RawPreview::take() {
  const auto outcome = task_.take();
  if (!outcome) return;
  picture_ = {};
  picture_.error = outcome->error;
  if (!outcome->result) return;
  texture_ = upload(*outcome->result);
  picture_.texture = texture_.id();
  picture_.size = outcome->result->size;
  picture_.range = outcome->result->range;
}

}  // namespace crest
