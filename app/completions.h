#pragma once

#include <string>

#include "app/option_table.h"

namespace crest {

/// A script that teaches a shell ("bash", "zsh" or "fish") the commands, their options, and the values that
/// these take.
std::string completions(const OptionTable& table, const std::string& shell);

}  // namespace crest
