#include <fmt/core.h>

#include "app/commands.h"
#include "app/completions.h"
#include "app/man_page.h"
#include "app/offscreen_context.h"
#include "app/option_help.h"
#include "presets/error.h"
#include "presets/exchange/exporters.h"
#include "presets/names.h"
#include "presets/preset_file.h"
#include "presets/preset_schema.h"
#include "render/files/load.h"
#include "render/measure/methods.h"
#include "render/volume/builtin.h"
#include "ui/mode_text.h"

namespace crest {
namespace {

void list_volumes() {
  for (const Builtin& builtin : builtins())
    fmt::print("builtin:{:<16} {}\n{:24} {}\n", builtin.name, builtin.summary, "", builtin.parameters);
}

void list_formats() {
  fmt::print("Volumes that are read:\n");
  for (const VolumeFormat& format : volume_formats())
    fmt::print("  {:<12} {:<28} {}\n", format.name, format.extensions, format.summary);
  fmt::print("Presets are written to:\n");
  for (const Exporter& exporter : exporters())
    fmt::print("  {:<16} {:<10} {}\n", exporter.name, exporter.extension, exporter.summary);
}

void list_methods() {
  fmt::print("Modes:\n");
  for (const Mode mode : {Mode::both, Mode::dvr_only, Mode::peak_only, Mode::peak_xor_dvr})
    fmt::print("  --mode {:<14} {}\n", name_of(mode), explanation_of(mode));
  fmt::print("What crest report measures, against which exact answers:\n");
  for (const Method& method : methods()) {
    std::string answers;
    for (const ExactAnswer& exact : exact_answers_of(method))
      answers += fmt::format("{} {}", answers.empty() ? "" : ",", name_of(exact));
    fmt::print("  {:<16} {}\n{:18} {}; against{}\n{:18} {}\n", method.id, method.name, "", method.settings,
               answers, "", method.limits);
  }
}

void list_graphics_devices() {
  const std::vector<std::string> devices = list_devices();
  if (devices.empty()) fmt::print("none\n");
  for (int i = 0; const auto& device : devices) fmt::print("{} {}\n", i++, device);
}

void list_presets() {
  for (const LibraryPreset& preset : library())
    fmt::print("{:<20} {}\n", preset.name, parse_preset(preset.text, preset.name).notes);
}

}  // namespace

namespace {

struct ListOptions {
  std::string what, shell;
  bool json = false;
};

void print_list(const ListOptions& options, const OptionTable& table) {
  const std::string& what = options.what;
  if (what == "volumes") list_volumes();
  if (what == "formats") list_formats();
  if (what == "methods") list_methods();
  if (what == "presets") list_presets();
  if (what == "devices") list_graphics_devices();
  if (what == "schema") fmt::print("{}", preset_schema());
  if (what == "options") fmt::print("{}", options.json ? options_json(table) : manual_page(table));
  if (what == "man") fmt::print("{}", man_page(table));
  if (what == "completions") fmt::print("{}", completions(table, options.shell));
}

}  // namespace

void add_list_command(Options app, Command& chosen) {
  auto options = std::make_shared<ListOptions>();
  Options command =
      app.add_command("list", "List volumes, formats, methods, presets, devices and more", "Look");
  command
      .add("WHAT", options->what,
           "What to list; schema is a preset's JSON Schema, options are those of all commands as the manual "
           "has "
           "them, man is the man page, completions are a shell's")
      .required()
      .one_of(
          {"volumes", "formats", "methods", "presets", "devices", "schema", "options", "man", "completions"});
  command.add("--for", options->shell, "Of completions: the shell")
      .one_of({"bash", "zsh", "fish"})
      .type_name("SHELL");
  command.add_flag("--json", options->json, "Of options: as JSON");
  command.add_example("crest list presets");
  command.add_example("crest list completions --for bash > ~/.local/share/bash-completion/completions/crest");
  command.when_read([options, app, &chosen] {
    if (options->what == "completions" && options->shell.empty())
      throw UsageError("--for", "say for which shell: bash, zsh or fish");
    chosen = [options, app] { print_list(*options, app.table()); };
  });
}

}  // namespace crest
