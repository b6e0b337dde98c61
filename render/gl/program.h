#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/handle.h"

namespace crest::gl {

/// Compiles and links a program that draws one triangle over the whole target with the fragment shader
/// `fragment` (a file of the shader folder). Throws Error with the file and line of the first fault.
ProgramHandle build_fullscreen_program(std::string_view fragment, const std::vector<std::string>& defines,
                                       const std::filesystem::path& folder = {});

}  // namespace crest::gl
