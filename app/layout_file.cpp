#include "app/layout_file.h"

#include <fmt/core.h>

#include "presets/atomic_file.h"
#include "presets/error.h"
#include "ui/studio_state.h"

namespace crest {

void LayoutFile::update(const Studio& studio) {
  if (path_.empty()) return;
  std::string text = fmt::format("title\t{}\nbusy\t{}\n", studio.title(),
                                 studio.is_drawing() || studio.is_loading() ? 1 : 0);
  for (const auto& [name, rect] : studio.ui_state().widgets.items)
    text += fmt::format("{}\t{:.0f}\t{:.0f}\n", name, 0.5f * (rect.first.x + rect.second.x),
                        0.5f * (rect.first.y + rect.second.y));
  if (text == last_) return;
  if (const std::string error = writer_.take_error(); !error.empty()) throw Error(error);
  writer_.start([path = path_, text] { replace_file(path, text); });
  last_ = std::move(text);
}

}  // namespace crest
