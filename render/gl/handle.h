#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace crest::gl {

/// Owns one GL object; move-only. 0 owns nothing. A context must be current whenever one dies.
template <void (*Delete)(GLuint)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle() {
    if (id_) Delete(id_);
  }
  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GLuint id_ = 0;
};

inline void delete_texture(GLuint id) { glDeleteTextures(1, &id); }
inline void delete_buffer(GLuint id) { glDeleteBuffers(1, &id); }
inline void delete_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline void delete_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }
inline void delete_shader(GLuint id) { glDeleteShader(id); }
inline void delete_program(GLuint id) { glDeleteProgram(id); }

using TextureHandle = Handle<delete_texture>;
using BufferHandle = Handle<delete_buffer>;
using FramebufferHandle = Handle<delete_framebuffer>;
using VertexArrayHandle = Handle<delete_vertex_array>;
using ShaderHandle = Handle<delete_shader>;
using ProgramHandle = Handle<delete_program>;

}  // namespace crest::gl
