#pragma once

#include <string>

#include "presets/preset.h"

namespace crest {

/// Why the exact march does not draw what these settings mean, in a sentence; empty where it does.
std::string why_not_exact(const Rendering& rendering);

/// The same picture without what sampling adds to it: by the exact march (classification analytic), to the
/// ray's end. What has no part in that is as it is by default, so that settings of the same picture are
/// equal. Only where why_not_exact() has nothing to say.
Rendering exact_rendering(const Rendering& rendering);

/// Whether these are such settings.
bool is_exact(const Rendering& rendering);

}  // namespace crest
