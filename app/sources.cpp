#include "app/sources.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "app/options.h"
#include "presets/preset_file.h"
#include "render/files/time_steps.h"
#include "render/volume/builtin.h"

namespace crest {
namespace fs = std::filesystem;

std::string absolute_source(const std::string& source) {
  if (source.empty() || source.starts_with("builtin:")) return source;
  return std::filesystem::absolute(source).lexically_normal().string();  // a query at the end stays there
}

std::vector<std::filesystem::path> files_of(const std::string& source) {
  const auto found = find_source(source);
  if (!found) return {};
  return found->list.empty() ? std::vector{found->path} : found->list;
}

namespace {

bool is_device(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

bool is_read_from(const fs::path& file, const fs::path& output) {
  std::error_code ignored;
  if (!fs::exists(output, ignored)) return false;
  if (!fs::is_directory(file, ignored)) return fs::equivalent(file, output, ignored);
  return fs::equivalent(file, fs::absolute(output, ignored).parent_path(), ignored);  // its images are read
}

}  // namespace

void require_other_files(const std::vector<OutputFile>& outputs, const std::vector<std::string>& read) {
  std::vector<fs::path> sources;
  for (const std::string& source : read)
    for (const fs::path& file : files_of(source)) sources.push_back(file);
  std::map<fs::path, const char*> written;
  for (const auto& [option, path] : outputs) {
    if (path.empty() || is_device(path)) continue;
    if (std::ranges::any_of(sources, [&](const fs::path& file) { return is_read_from(file, path); }))
      throw UsageError(option, path.string() + " is what is read, which would be lost");
    std::error_code ignored;
    const auto [other, is_new] = written.emplace(fs::weakly_canonical(path, ignored), option);
    if (!is_new)
      throw UsageError(
          option, fmt::format("{} is what {} writes, too; say another file", path.string(), other->second));
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
