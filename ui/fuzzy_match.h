#pragma once

#include <optional>
#include <string_view>

namespace crest {

/// How well what was typed fits a text; nothing where it does not. The letters of each typed word must stand
/// in the text in their order, whatever is between them and whether large or small. It counts for more where
/// they begin words, as in "sa" for "Save as", and where they follow each other.
std::optional<int> match_score(std::string_view typed, std::string_view text);

}  // namespace crest
