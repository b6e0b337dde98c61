#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace crest {

/// What a command line asks for, run once the whole of it was understood. Throws Error.
using Action = std::function<void()>;

// Each adds one command, which puts its action into `chosen`. A new command is a new file, and a line here.
void add_render_command(CLI::App& app, Action& chosen);
void add_compare_command(CLI::App& app, Action& chosen);
void add_stability_command(CLI::App& app, Action& chosen);
void add_peaks_command(CLI::App& app, Action& chosen);
void add_info_command(CLI::App& app, Action& chosen);
void add_export_command(CLI::App& app, Action& chosen);
void add_list_command(CLI::App& app, Action& chosen);
/// The studio is what runs without a command.
void add_studio(CLI::App& app, Action& chosen);

}  // namespace crest
