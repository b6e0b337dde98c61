#include "render/resources/tf_pieces_buffer.h"

#include <fmt/core.h>

#include "presets/error.h"
#include "render/gl/errors.h"

namespace crest {
namespace {

constexpr std::size_t texels_of_piece = 6;
static_assert(sizeof(TfPiece) == texels_of_piece * sizeof(glm::vec4));

struct TfPiecesKey {
  TransferFunction tf;
  std::vector<Peak> surfaces;
  double smallest_spacing;
  bool operator==(const TfPiecesKey&) const = default;
};

TfPiecesTexture upload(const TfPieces& pieces) {
  const std::size_t count = pieces.pieces.size();
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (count * texels_of_piece > std::size_t(most))
    throw Error(fmt::format("a transfer function of {} pieces is more than the graphics driver holds: {}", count,
                            std::size_t(most) / texels_of_piece));
  GLuint buffer = 0, texture = 0;
  glCreateBuffers(1, &buffer);
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &texture);
  TfPiecesTexture result{gl::BufferHandle(buffer), gl::TextureHandle(texture), int(count), pieces.extinction_scale};
  glNamedBufferStorage(buffer, GLsizeiptr(count * sizeof(TfPiece)), pieces.pieces.data(), 0);
  glTextureBuffer(texture, GL_RGBA32F, buffer);
  gl::require_no_error("making room for the transfer function");
  return result;
}

}  // namespace

const TfPiecesTexture& tf_pieces_texture(KeyedCache& held, const TransferFunction& tf,
                                         const std::vector<Peak>& surfaces, double smallest_spacing) {
  const std::size_t most_pieces = 4 * tf.points.size() + surfaces.size() + 1;
  return held.get(TfPiecesKey{tf, surfaces, smallest_spacing}, most_pieces * sizeof(TfPiece),
                  [&] { return upload(build_tf_pieces(tf, surfaces, smallest_spacing)); });
}

}  // namespace crest
