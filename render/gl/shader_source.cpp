#include "render/gl/shader_source.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "presets/atomic_file.h"
#include "presets/error.h"
#include "shader_files_embedded.h"

namespace crest::gl {
namespace {

std::string read_shader_file(std::string_view name, const std::filesystem::path& folder) {
  if (!folder.empty()) return read_file(folder / name, 1 << 20);
  for (const auto& file : shader_files::embedded_files())
    if (file.name == fmt::format("shaders/{}", name)) return std::string(file.text);
  throw Error(fmt::format("shader {} is not part of this program", name));
}

/// Lines of file n are numbered from n * 10,000: Mesa 22.3 gives source string 0 for some errors, whatever
/// `#line` says.
constexpr std::size_t lines_per_file = 10000;

std::string line_directive(std::size_t file, std::size_t line) {
  return fmt::format("#line {}\n", file * lines_per_file + line);
}

/// The file that `#include "file"` names; empty for another line.
std::string included_file(const std::string& line) {
  const auto first = line.find_first_not_of(" \t");
  if (first == line.npos || line.compare(first, 8, "#include") != 0) return {};
  const auto open = line.find('"', first), close = line.rfind('"');
  return close > open ? line.substr(open + 1, close - open - 1) : std::string();
}

void append_file(ShaderSource& source, std::string_view name, const std::filesystem::path& folder) {
  if (std::ranges::find(source.files, name) != source.files.end()) return;  // each file once
  const auto index = source.files.size();
  source.files.emplace_back(name);
  source.text += line_directive(index, 1);

  std::istringstream lines(read_shader_file(name, folder));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (const std::string included = included_file(line); !included.empty()) {
      append_file(source, included, folder);
      source.text += line_directive(index, number + 1);
    } else {
      source.text += line + '\n';
    }
  }
}

}  // namespace

ShaderSource load_shader(std::string_view name, const std::vector<std::string>& defines,
                         const std::filesystem::path& folder) {
  ShaderSource source;
  source.text = "#version 450 core\n";
  for (const auto& define : defines) source.text += fmt::format("#define {}\n", define);
  append_file(source, name, folder);
  return source;
}

// Mesa and Intel write "0:12(3): error", AMD "ERROR: 0:12:", NVIDIA "0(12) : error".
std::string name_files_in_log(std::string_view log, const std::vector<std::string>& files) {
  std::string named;
  std::istringstream lines{std::string(log)};
  for (std::string line; std::getline(lines, line);) {
    const auto place = std::min(line.find_first_of("0123456789"), line.size());
    std::size_t string = 0, number = 0;
    int length = 0;
    const char* text = line.c_str() + place;
    const bool found = std::sscanf(text, "%zu:%zu%n", &string, &number, &length) == 2 ||
                       std::sscanf(text, "%zu(%zu)%n", &string, &number, &length) == 2;
    if (found && number / lines_per_file < files.size())
      line = fmt::format("{}{}:{}{}", line.substr(0, place), files[number / lines_per_file],
                         number % lines_per_file, text + length);
    named += line + '\n';
  }
  return named;
}

}  // namespace crest::gl
