#pragma once

#include <string>

namespace crest {

/// The program: parses the command line and runs the command. 0 done; 1 the work failed; 2 the command line
/// is wrong. `version` is told by --version.
int run_command_line(int argc, char** argv, const std::string& version);

}  // namespace crest
