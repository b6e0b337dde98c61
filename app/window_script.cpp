#include "app/window_script.h"

#include <nlohmann/json.hpp>

#include "presets/atomic_file.h"
#include "ui/studio_state.h"

namespace crest {

void LayoutFile::update(const Studio& studio) {
  if (path_.empty()) return;
  nlohmann::ordered_json json;
  json["busy"] = studio.is_busy();
  json["title"] = studio.title();
  for (const auto& [name, rect] : studio.ui_state().widgets.items)
    json["widgets"][name] = {rect.first.x, rect.first.y, rect.second.x, rect.second.y};
  std::string text = json.dump(1) + "\n";
  if (text == last_) return;
  write_file_atomically(path_, text);
  last_ = std::move(text);
}

}  // namespace crest
