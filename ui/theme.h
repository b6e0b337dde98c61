#pragma once

namespace crest {

/// The colours of the window, as a whole.
enum class Theme { dark, light };

}  // namespace crest
