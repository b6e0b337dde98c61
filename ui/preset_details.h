#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/studio_state.h"

namespace crest {

/// "CT, medical" from the tags, and back: without spaces about a tag, empty ones and such as are there
/// already.
std::string tags_text(const std::vector<std::string>& tags);
std::vector<std::string> tags_in(std::string_view text);

/// The window for the preset's name, notes and tags, once state.details.asked. Returns whether it changed the
/// document.
bool preset_details(Document& document, StudioState& state);

}  // namespace crest
