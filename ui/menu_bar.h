#pragma once

#include "ui/actions.h"
#include "ui/studio_state.h"

namespace crest {

/// The menus, with the preset's name at the right. Returns whether it changed the document.
bool menu_bar(const ActionContext& context);

}  // namespace crest
