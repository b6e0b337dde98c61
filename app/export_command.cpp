#include <fmt/core.h>

#include "app/commands.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/exporters.h"
#include "presets/preset_file.h"
#include "render/files/load.h"

namespace crest {
namespace {

struct ExportCommandOptions {
  std::string preset, format, output, volume;
  ExportOptions format_options;
};

void export_preset(const ExportCommandOptions& options) {
  const Exporter& exporter = find_exporter(options.format);
  const Preset preset = load_preset(options.preset);
  TransferFunction tf = preset.transfer_function;
  if (!options.volume.empty()) {
    const Volume volume = load_volume(options.volume);
    tf = resolve(tf, volume.statistics.range, volume.grid.smallest_spacing());
  }
  const std::string name =
      preset.name.empty() ? std::filesystem::path(options.preset).stem().string() : preset.name;
  write_file_atomically(options.output, exporter.write(name, tf, options.format_options));
  const std::string losses = exporter.losses(tf, options.format_options);
  fmt::print(stderr, "{}", losses);
}

}  // namespace

void add_export_command(Options app, Action& chosen) {
  auto options = std::make_shared<ExportCommandOptions>();
  Options command = app.add_command("export", "Write a preset for another program");
  std::string formats;
  for (const Exporter& exporter : exporters())
    formats += fmt::format("\n{}: {}", exporter.name, exporter.summary);
  command.add("PRESET", options->preset, "A preset's file, or its name in the library").required();
  command.add("--to", options->format, "Format:" + formats)
      .required()
      .type_name("FORMAT")
      .check([](const std::string& name) {
        try {
          find_exporter(name);
          return std::string();
        } catch (const Error& error) {
          return std::string(error.what());
        }
      });
  command.add("-o,--output", options->output, "The file to write").required().type_name("FILE");
  command.add("--volume", options->volume, "Write a normalized preset in this volume's values and units");
  command.add("--samples", options->format_options.samples, "Rows of a sampled format")
      .in(2, 1048576)
      .shows_default();
  command.when_read([options, &chosen] { chosen = [options] { export_preset(*options); }; });
}

}  // namespace crest
