#include "render/gl/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
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

void append_file(ShaderSource& source, std::string_view name, const std::filesystem::path& folder) {
  if (std::ranges::find(source.files, name) != source.files.end()) return;  // each file once
  const auto index = source.files.size();
  source.files.emplace_back(name);
  source.text += fmt::format("#line 1 {}\n", index);

  static const std::regex include(R"re(^\s*#include\s+"([^"]+)"\s*$)re");
  std::istringstream lines(read_shader_file(name, folder));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch match;
    if (std::regex_match(line, match, include)) {
      append_file(source, match[1].str(), folder);
      source.text += fmt::format("#line {} {}\n", number + 1, index);
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

std::string name_files_in_log(std::string_view log, const std::vector<std::string>& files) {
  // Mesa and Intel write "0:12(3):", NVIDIA "0(12) :", AMD "0:12:".
  static const std::regex place(R"re((\d+):(\d+)(\(\d+\))?:|(\d+)\((\d+)\) ?:)re");
  std::string named;
  std::istringstream lines{std::string(log)};
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, place)) {
      const auto index = std::stoul(match[1].matched ? match[1] : match[4]);
      const auto number = match[2].matched ? match[2].str() : match[5].str();
      if (index < files.size())
        line = fmt::format("{}{}:{}:{}", match.prefix().str(), files[index], number, match.suffix().str());
    }
    named += line + '\n';
  }
  return named;
}

}  // namespace crest::gl
