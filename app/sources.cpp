#include "app/sources.h"

#include <fmt/core.h>

#include "app/options.h"
#include "presets/preset_file.h"
#include "render/files/time_steps.h"
#include "render/volume/builtin.h"

namespace crest {

std::string absolute_source(const std::string& source) {
  if (source.empty() || source.starts_with("builtin:")) return source;
  return std::filesystem::absolute(source).lexically_normal().string();  // a query at the end stays there
}

std::vector<std::filesystem::path> files_of(const std::string& source) {
  const auto found = find_source(source);
  if (!found) return {};
  return found->list.empty() ? std::vector{found->path} : found->list;
}

void require_other_file(const std::filesystem::path& output, const std::string& read, const char* option) {
  std::error_code ignored;
  if (!std::filesystem::exists(output, ignored)) return;
  const auto folder = std::filesystem::absolute(output, ignored).parent_path();
  for (const std::filesystem::path& file : files_of(read)) {
    const bool is_same = std::filesystem::is_directory(file, ignored)
                             ? std::filesystem::equivalent(file, folder, ignored)  // its images are read
                             : std::filesystem::equivalent(file, output, ignored);
    if (is_same) throw UsageError(option, output.string() + " is what is read, which would be lost");
  }
}

std::vector<std::string> builtin_sources() {
  std::vector<std::string> sources;
  for (const Builtin& builtin : builtins()) sources.push_back(fmt::format("builtin:{}", builtin.name));
  return sources;
}

std::vector<std::string> library_names() {
  std::vector<std::string> names;
  for (const LibraryPreset& preset : library()) names.emplace_back(preset.name);
  return names;
}

}  // namespace crest
