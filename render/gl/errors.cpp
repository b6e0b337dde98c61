#include "render/gl/errors.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include "presets/error.h"

namespace crest::gl {

void forget_errors() {
  while (glGetError() != GL_NO_ERROR) {
  }
}

void require_no_error(std::string_view doing, glm::ivec2 size) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  const std::string why =
      error == GL_OUT_OF_MEMORY ? "is out of memory" : fmt::format("failed (GL error 0x{:x})", error);
  forget_errors();
  throw Error(
      fmt::format("the graphics driver {} while {} a picture of {}x{} pixels", why, doing, size.x, size.y));
}

}  // namespace crest::gl
