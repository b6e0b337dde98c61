#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace crest::gl {

/// One shader's text with its includes joined; its line numbers also say which of `files` a line is from.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;
};

/// Reads `name` (below the shader folder) and each `#include "file"` once, with `#define`s after the version
/// line. With an empty `folder` the files are those embedded in the program. Throws Error for a file that is
/// missing.
ShaderSource load_shader(std::string_view name, const std::vector<std::string>& defines,
                         const std::filesystem::path& folder = {});

/// A driver's log with file names and their own line numbers: "0:20012(3): error" -> "ray.glsl:12(3): error".
std::string name_files_in_log(std::string_view log, const std::vector<std::string>& files);

}  // namespace crest::gl
