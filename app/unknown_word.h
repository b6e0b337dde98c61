#pragma once

#include <string>
#include <vector>

#include "app/option_table.h"

namespace crest {

/// What to say of a word that stands where none is expected, with the nearest right one. `argument` is the
/// first word that is no option, where no command was chosen: it may have been meant for one.
std::string about_extra_word(const OptionTable& table, const CommandRow& command, const std::string& word,
                             const std::string& argument);

/// "; did you mean render?" for a word that was perhaps meant for a command; else empty.
std::string meant_command(const OptionTable& table, const std::string& word);

/// Nothing where `word` is one of `words`; else a sentence that lists them.
std::string why_not_one_of(const std::string& word, const std::vector<std::string>& words);

}  // namespace crest
