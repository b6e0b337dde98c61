#include "render/resources/shader_tf_texture.h"

#include <fmt/core.h>

#include "presets/error.h"
#include "render/gl/errors.h"

namespace crest {
namespace {

constexpr std::size_t texels_of_piece = 4;
static_assert(sizeof(ShaderTfPiece) == texels_of_piece * sizeof(glm::vec4));

struct ShaderTfKey {
  TransferFunction tf;
  std::vector<Peak> surfaces;
  ValueRange field;
  double smallest_spacing;
  bool operator==(const ShaderTfKey&) const = default;
};

ShaderTfTexture upload(const ShaderTf& pieces) {
  const std::size_t count = pieces.pieces.size();
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (count * texels_of_piece > std::size_t(most))
    throw Error(fmt::format("a transfer function of {} pieces is more than the graphics driver holds: {}",
                            count, std::size_t(most) / texels_of_piece));
  GLuint buffer = 0, texture = 0;
  glCreateBuffers(1, &buffer);
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &texture);
  ShaderTfTexture result{gl::BufferHandle(buffer), gl::TextureHandle(texture), int(count),
                         pieces.extinction_scale};
  glNamedBufferStorage(buffer, GLsizeiptr(count * sizeof(ShaderTfPiece)), pieces.pieces.data(), 0);
  glTextureBuffer(texture, GL_RGBA32F, buffer);
  gl::require_no_error("making room for the transfer function");
  return result;
}

}  // namespace

const ShaderTfTexture& shader_tf_texture(KeyedCache& held, const TransferFunction& tf,
                                         const std::vector<Peak>& surfaces, ValueRange field,
                                         double smallest_spacing) {
  const std::size_t most_pieces = 6 * tf.points.size() + surfaces.size() + 1;
  return held.get(ShaderTfKey{tf, surfaces, field, smallest_spacing}, most_pieces * sizeof(ShaderTfPiece),
                  [&] { return upload(shader_tf(tf, surfaces, field, smallest_spacing)); });
}

}  // namespace crest
