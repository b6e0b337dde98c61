#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/handle.h"
#include "render/gl/shader_source.h"

namespace crest::gl {

/// A program's shaders, with their includes joined.
struct ProgramSource {
  ShaderSource vertex, fragment;
};

/// Reads two files of the shader folder, as load_shader(). The defines are the fragment shader's.
ProgramSource load_program(std::string_view vertex, std::string_view fragment,
                           const std::vector<std::string>& defines, const std::filesystem::path& folder = {});

/// Compiles and links. Throws Error with the file and line of the first fault.
ProgramHandle build_program(const ProgramSource& source);
ProgramHandle build_program(std::string_view vertex, std::string_view fragment,
                            const std::vector<std::string>& defines,
                            const std::filesystem::path& folder = {});

/// One that draws one triangle over the whole target.
ProgramHandle build_fullscreen_program(std::string_view fragment, const std::vector<std::string>& defines,
                                       const std::filesystem::path& folder = {});

}  // namespace crest::gl
