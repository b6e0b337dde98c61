#include "render/gl/program.h"

#include <fmt/core.h>

#include "presets/error.h"

namespace crest::gl {
namespace {

ShaderHandle compile(GLenum stage, const ShaderSource& source) {
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

ProgramSource load_program(std::string_view vertex, std::string_view fragment,
                           const std::vector<std::string>& defines, const std::filesystem::path& folder) {
  return {load_shader(vertex, {}, folder), load_shader(fragment, defines, folder)};
}

ProgramHandle build_program(const ProgramSource& source) {
  const ShaderHandle vertex = compile(GL_VERTEX_SHADER, source.vertex);
  const ShaderHandle fragment = compile(GL_FRAGMENT_SHADER, source.fragment);
  ProgramHandle program(glCreateProgram());
  glProgramParameteri(program.id(), GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  glAttachShader(program.id(), vertex.id());
  glAttachShader(program.id(), fragment.id());
  glLinkProgram(program.id());
  GLint linked = 0;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (!linked) {
    char log[1024] = "";
    glGetProgramInfoLog(program.id(), sizeof log, nullptr, log);
    throw Error(fmt::format("shader program {} does not link: {}", source.fragment.files.front(), log));
  }
  return program;
}

ProgramHandle build_program(std::string_view vertex, std::string_view fragment,
                            const std::vector<std::string>& defines, const std::filesystem::path& folder) {
  return build_program(load_program(vertex, fragment, defines, folder));
}

ProgramHandle build_fullscreen_program(std::string_view fragment, const std::vector<std::string>& defines,
                                       const std::filesystem::path& folder) {
  return build_program("fullscreen.vert", fragment, defines, folder);
}

}  // namespace crest::gl
