#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crest {

/// How many letters are to be changed, added or left out, or neighbours swapped, to make one word of the
/// other; capitals count as small letters (optimal string alignment: Damerau 1964, with no letter moved
/// twice).
int edit_distance(std::string_view a, std::string_view b);

/// The word of `known` that `word` was likely meant to be: the first that begins with it, or the nearest one
/// within a third of the word's letters. Empty where none is near.
std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known);

/// "; did you mean --preset?", to end a message with; empty where no word is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace crest
