#pragma once

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "app/offscreen_context.h"

namespace crest::testing {

/// A context in which each wrong use of GL fails the test that makes it. (Of shaders that do not compile an
/// Error tells.)
struct DebugContext : OffscreenContext {
  DebugContext() : OffscreenContext(-1, true) {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(
        [](GLenum source, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void*) {
          if (type == GL_DEBUG_TYPE_ERROR && source == GL_DEBUG_SOURCE_API) ADD_FAILURE() << message;
        },
        nullptr);
  }
};

}  // namespace crest::testing
