#include <fmt/format.h>

#include "app/commands.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/exporters.h"
#include "presets/preset_file.h"
#include "render/volume/load.h"

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

void add_export_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<ExportCommandOptions>();
  CLI::App* command = app.add_subcommand("export", "Write a preset for another program");
  std::string formats;
  for (const Exporter& exporter : exporters())
    formats += fmt::format("\n{}: {}", exporter.name, exporter.summary);
  command->add_option("PRESET", options->preset, "A preset's file, or its name in the library")->required();
  command->add_option("--to", options->format, "Format:" + formats)
      ->required()
      ->type_name("FORMAT")
      ->check([](const std::string& name) {
        try {
          find_exporter(name);
          return std::string();
        } catch (const Error& error) {
          return std::string(error.what());
        }
      });
  command->add_option("-o,--output", options->output, "The file to write")->required()->type_name("FILE");
  command->add_option("--volume", options->volume,
                      "Write a normalized preset in this volume's values and units");
  command->add_option("--samples", options->format_options.samples, "Rows of a sampled format")
      ->check(CLI::Range(2, 1048576))
      ->capture_default_str();
  command->callback([options, &chosen] { chosen = [options] { export_preset(*options); }; });
}

}  // namespace crest
