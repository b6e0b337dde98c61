#pragma once

#include <functional>

#include "app/options.h"

namespace crest {

/// What a command line asks for, run once the whole of it was understood. Throws Error.
using Command = std::function<void()>;

// Each adds one command, which puts its action into `chosen`. A new command is a new file, and a line here.
void add_render_command(Options app, Command& chosen);
void add_compare_command(Options app, Command& chosen);
void add_report_command(Options app, Command& chosen);
void add_stability_command(Options app, Command& chosen);
void add_peaks_command(Options app, Command& chosen);
void add_info_command(Options app, Command& chosen);
void add_export_command(Options app, Command& chosen);
void add_import_command(Options app, Command& chosen);
void add_match_command(Options app, Command& chosen);
void add_list_command(Options app, Command& chosen);
/// The studio is what runs without a command.
void add_studio(Options app, Command& chosen);

}  // namespace crest
