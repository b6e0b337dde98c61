#include "render/gl/errors.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <string>

namespace crest::gl {
namespace {

[[noreturn]] void throw_error(GLenum error, std::string_view doing) {
  forget_errors();
  if (error == GL_OUT_OF_MEMORY)
    throw NoRoom(fmt::format("the graphics driver is out of memory while {}", doing));
  throw Error(fmt::format("the graphics driver failed (GL error 0x{:x}) while {}", error, doing));
}

}  // namespace

void forget_errors() {
  while (glGetError() != GL_NO_ERROR) {
  }
}

void require_no_error(std::string_view doing) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) throw_error(error, doing);
}

void require_no_error(std::string_view doing, glm::ivec2 size) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    throw_error(error, fmt::format("{} a picture of {}x{} pixels", doing, size.x, size.y));
}

}  // namespace crest::gl
