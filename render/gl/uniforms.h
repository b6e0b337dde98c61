#pragma once

#include <epoxy/gl.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace crest::gl {

// A uniform of a program, by its name; one that the program does not have is passed over.

inline void set(GLuint program, const char* name, int i) {
  glProgramUniform1i(program, glGetUniformLocation(program, name), i);
}
inline void set(GLuint program, const char* name, float x) {
  glProgramUniform1f(program, glGetUniformLocation(program, name), x);
}
inline void set(GLuint program, const char* name, glm::vec2 v) {
  glProgramUniform2f(program, glGetUniformLocation(program, name), v.x, v.y);
}
inline void set(GLuint program, const char* name, glm::vec3 v) {
  glProgramUniform3f(program, glGetUniformLocation(program, name), v.x, v.y, v.z);
}

}  // namespace crest::gl
