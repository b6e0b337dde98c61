#include "ui/view_content.h"

#include "presets/choices.h"
#include "ui/mode_text.h"

namespace crest {

std::array<ViewContent, view_count> contents_of_modes() {
  std::array<ViewContent, view_count> contents;
  for (std::size_t i = 0; i < view_count; ++i) contents[i].mode = view_modes[i];
  return contents;
}

Rendering rendering_of(const ViewContent& content, const Preset& documents) {
  Rendering rendering = (content.other ? content.other->preset : documents).rendering;
  rendering.engine = content.engine.value_or(rendering.engine);
  return in_mode(rendering, content.mode);
}

Preset preset_of(const ViewContent& content, const Preset& documents) {
  Preset preset = content.other ? content.other->preset : documents;
  preset.rendering = rendering_of(content, documents);
  return preset;
}

std::string text_of(const ViewContent& content) {
  std::string text = title_of(content.mode);
  if (content.engine) text += *content.engine == Engine::vdls ? ", VDLS" : ", ray caster";
  if (content.picture)
    text += *content.picture == ShownPicture::exact         ? ", exact"
            : *content.picture == ShownPicture::error_bound ? ", error bound"
                                                            : ", as set";
  if (content.other) text += ", " + content.other->name;
  return text;
}

}  // namespace crest
