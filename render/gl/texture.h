#pragma once

#include "render/gl/handle.h"

namespace crest::gl {

/// A texture without storage yet, of one level, filtered by GL_NEAREST or GL_LINEAR, that repeats its edge
/// outside.
inline TextureHandle make_texture(GLenum target, GLint filter) {
  GLuint id = 0;
  glCreateTextures(target, 1, &id);
  for (const GLenum which : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTextureParameteri(id, which, filter);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTextureParameteri(id, wrap, GL_CLAMP_TO_EDGE);
  return TextureHandle(id);
}

}  // namespace crest::gl
