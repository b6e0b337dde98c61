#include "render/raycaster/preintegration_textures.h"

namespace crest {
namespace {

gl::TextureHandle upload_rgba(GLsizei width, GLsizei height, GLint filter, const void* data) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  gl::TextureHandle texture(id);
  glTextureStorage2D(id, 1, GL_RGBA32F, width, height);
  glTextureSubImage2D(id, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, data);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, filter);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, filter);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

AntiderivativesTexture upload_antiderivatives(const Antiderivatives& table) {
  static_assert(sizeof(Antiderivatives::Entry) == 4 * sizeof(glm::vec4));
  const auto entries = GLsizei(table.entries.size());
  return {upload_rgba(4, entries, GL_NEAREST, table.entries.data()), table.range, int(entries) - 2};
}

PreintegrationTexture upload_preintegration_table(const PreintegrationTable& table) {
  return {upload_rgba(table.bins, table.bins, GL_LINEAR, table.entries.data()), table.range, table.length,
          table.bins};
}

}  // namespace crest
