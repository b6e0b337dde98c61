#include <fmt/core.h>

#include "app/commands.h"
#include "app/offscreen_context.h"
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

void add_list_command(Options app, Action& chosen) {
  auto what = std::make_shared<std::string>();
  Options command = app.add_command(
      "list",
      "List what there is: volumes, formats, methods, presets or devices; or the JSON Schema of a preset");
  command.add("WHAT", *what, "What to list")
      .required()
      .one_of({"volumes", "formats", "methods", "presets", "devices", "schema"});
  command.when_read([what, &chosen] {
    chosen = [what] {
      if (*what == "volumes") list_volumes();
      if (*what == "formats") list_formats();
      if (*what == "methods") list_methods();
      if (*what == "presets") list_presets();
      if (*what == "devices") list_graphics_devices();
      if (*what == "schema") fmt::print("{}", preset_schema());
    };
  });
}

}  // namespace crest
