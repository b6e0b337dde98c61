#include "render/gl/program.h"

#include <fmt/core.h>

#include "presets/error.h"
#include "render/gl/shader_source.h"

namespace crest::gl {
namespace {

ShaderHandle compile(GLenum stage, std::string_view name, const std::vector<std::string>& defines,
                     const std::filesystem::path& folder) {
  const ShaderSource source = load_shader(name, defines, folder);
  ShaderHandle shader(glCreateShader(stage));
  const char* text = source.text.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint compiled = 0, length = 0;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    glGetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(length > 0 ? length : 1), '\0');
    glGetShaderInfoLog(shader.id(), length, nullptr, log.data());
    throw Error(fmt::format("shader does not compile: {}", name_files_in_log(log.c_str(), source.files)));
  }
  return shader;
}

}  // namespace

ProgramHandle build_program(std::string_view vertex, std::string_view fragment,
                            const std::vector<std::string>& defines, const std::filesystem::path& folder) {
  const ShaderHandle vertex_shader = compile(GL_VERTEX_SHADER, vertex, {}, folder);
  const ShaderHandle fragment_shader = compile(GL_FRAGMENT_SHADER, fragment, defines, folder);
  ProgramHandle program(glCreateProgram());
  glAttachShader(program.id(), vertex_shader.id());
  glAttachShader(program.id(), fragment_shader.id());
  glLinkProgram(program.id());
  GLint linked = 0;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (!linked) {
    char log[1024] = "";
    glGetProgramInfoLog(program.id(), sizeof log, nullptr, log);
    throw Error(fmt::format("shader program {} does not link: {}", fragment, log));
  }
  return program;
}

ProgramHandle build_fullscreen_program(std::string_view fragment, const std::vector<std::string>& defines,
                                       const std::filesystem::path& folder) {
  return build_program("fullscreen.vert", fragment, defines, folder);
}

}  // namespace crest::gl
