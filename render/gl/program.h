#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/handle.h"

namespace crest::gl {

/// Compiles and links two files of the shader folder. The defines are the fragment shader's. Throws Error
/// with the file and line of the first fault.
ProgramHandle build_program(std::string_view vertex, std::string_view fragment,
                            const std::vector<std::string>& defines,
                            const std::filesystem::path& folder = {});

/// One that draws one triangle over the whole target.
ProgramHandle build_fullscreen_program(std::string_view fragment, const std::vector<std::string>& defines,
                                       const std::filesystem::path& folder = {});

}  // namespace crest::gl
