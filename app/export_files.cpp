#include "app/export_files.h"

#include "presets/atomic_file.h"

namespace crest {

std::string stem_of(const std::filesystem::path& output, std::string_view extension) {
  const std::string name = output.filename().string();
  return name.ends_with(extension) ? name.substr(0, name.size() - extension.size()) : output.stem().string();
}

std::filesystem::path path_of(const std::filesystem::path& output, const std::string& stem,
                              const ExportFile& file) {
  return file.suffix.empty() ? output : output.parent_path() / (stem + file.suffix);
}

void write_export(const Exported& exported, const std::string& stem, const std::filesystem::path& output) {
  // What others name is there before what names it
  for (auto file = exported.files.rbegin(); file != exported.files.rend(); ++file)
    write_file_atomically(path_of(output, stem, *file), file->content);
}

}  // namespace crest
