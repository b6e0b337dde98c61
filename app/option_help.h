#pragma once

#include <string>
#include <vector>

#include "app/option_table.h"

namespace crest {

// What people read of the command line, made from its table.

/// `crest --help`: what the program is, examples, its commands; it fits a screen of 30 lines and 80 columns.
std::string program_help(const OptionTable& table);

/// `crest COMMAND --help`: each option, in lines of at most 80 columns.
std::string command_help(const CommandRow& command);

/// "crest render VOLUME -o FILE [OPTIONS]".
std::string usage_line(const CommandRow& command);

/// The rows of a command: arguments first, as they are typed; what every command has at the end.
std::vector<const OptionRow*> in_order(const CommandRow& command);

/// "-o, --output FILE".
std::string option_text(const OptionRow& row);

/// What an option is for: its help, the words it may have, its default.
std::string option_meaning(const OptionRow& row);

/// The manual's page of options, in Markdown.
std::string manual_page(const OptionTable& table);

/// The table for programs, as JSON.
std::string options_json(const OptionTable& table);

}  // namespace crest
