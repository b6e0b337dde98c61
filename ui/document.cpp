#include "ui/document.h"

namespace crest {

std::string preset_label(const Document& document) {
  if (!document.preset_path.empty()) return document.preset_path.filename().string();
  return document.library_name.empty() ? "new preset" : document.library_name + " (library)";
}

bool is_same_preset_file(const Document& a, const Document& b) {
  return a.preset_path == b.preset_path && a.library_name == b.library_name;
}

}  // namespace crest
