#pragma once

#include <string>
#include <string_view>

#include "presets/transfer_function.h"

namespace crest {

/// Control points as JSON, to be carried through the clipboard: {"domain": "data", "points": [...]}, each
/// point as in a preset.
std::string points_text(const TransferFunction& points);

/// The points in such a text, or in that of a whole preset, with the domain of their values. Throws Error.
TransferFunction points_in(std::string_view text);

}  // namespace crest
