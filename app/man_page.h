#pragma once

#include <string>

#include "app/option_table.h"

namespace crest {

/// crest(1), in the man macros: the program, its commands with all their options, files and exit codes.
std::string man_page(const OptionTable& table);

}  // namespace crest
