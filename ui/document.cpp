#include "ui/document.h"

namespace crest {

Preset new_preset() {
  Preset preset;
  preset.transfer_function = default_transfer_function();
  preset.rendering.shading = Shading::gradient;
  return preset;
}

std::string preset_label(const Document& document) {
  if (!document.preset_path.empty()) return document.preset_path.filename().string();
  return document.library_name.empty() ? "new preset" : document.library_name + " (library)";
}

bool is_same_preset_file(const Document& a, const Document& b) {
  return a.preset_path == b.preset_path && a.library_name == b.library_name;
}

bool is_preset_name(const std::string& source) { return source.ends_with(".json"); }

std::string file_name(const std::string& source) {
  const std::size_t slash = source.rfind('/');
  return slash == source.npos || slash + 1 == source.size() ? source : source.substr(slash + 1);
}

}  // namespace crest
