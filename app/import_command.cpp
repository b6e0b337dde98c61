#include <fmt/core.h>

#include "app/commands.h"
#include "app/load_with_progress.h"
#include "app/sources.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/exchange/importers.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/preset_file.h"
#include "presets/printable.h"

namespace crest {
namespace {

struct ImportOptions {
  std::string file, output, volume, name, take = "both", onto;
  bool list = false, json = false, fit = false;
};

TfParts parts_of(const std::string& word) {
  return word == "colors" ? TfParts::colors : word == "opacities" ? TfParts::opacities : TfParts::both;
}

void list_names(const std::vector<Imported>& all, bool as_json) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Imported& one : all) {
    if (as_json)
      json.push_back({{"name", one.preset.name},
                      {"points", one.preset.transfer_function.points.size()},
                      {"colors", one.has_colors},
                      {"opacities", one.has_opacities}});
    else
      fmt::print("{}\n", printable(one.preset.name));
  }
  if (as_json) fmt::print("{}\n", pretty(json));
}

void import_file(const ImportOptions& options) {
  if (options.list) return list_names(import_presets(options.file), options.json);
  if (options.output.empty()) throw UsageError("--output", "say which preset to write, or --list");
  const TfParts take = parts_of(options.take);
  if (take != TfParts::both && options.onto.empty())
    throw UsageError("--onto", "say of which preset the rest is taken");
  require_other_files({{"--output", options.output}}, {options.file, options.volume});
  require_writable(options.output);
  const std::vector<Imported> all = import_presets(options.file);
  const Imported& chosen = choose(all, options.name, options.file);
  TransferFunction read = chosen.preset.transfer_function;
  Preset preset = options.onto.empty() ? chosen.preset : load_preset(options.onto);
  if (!options.volume.empty()) {
    const Volume volume = load_with_progress(options.volume);
    const auto in_volume = [&](const TransferFunction& tf) {
      return resolve(tf, volume.statistics.range, volume.grid.smallest_spacing());
    };
    read = in_volume(for_volume(chosen, glm::dvec3(volume.grid.dims) * volume.grid.spacing));
    if (options.fit && options.onto.empty()) read = remap_values(read, read.range(), volume.statistics.range);
    preset.transfer_function = in_volume(preset.transfer_function);
  } else if (options.fit && options.onto.empty()) {
    throw UsageError("--fit", "say over what: a --volume, or a preset with --onto");
  }
  preset.transfer_function =
      options.onto.empty() ? read : combined(preset.transfer_function, read, take, options.fit);
  save_preset(options.output, preset);
  if (options.json)
    fmt::print("{}\n", pretty({{"file", options.output}, {"name", preset.name}, {"notes", chosen.notes}}));
  else
    for (const std::string& note : chosen.notes) fmt::print(stderr, "note: {}\n", printable(note));
}

}  // namespace

void add_import_command(Options app, Command& chosen) {
  auto options = std::make_shared<ImportOptions>();
  Options command =
      app.add_command("import", "Read another program's transfer function", "Presets elsewhere");
  std::string formats;
  for (const Importer& importer : importers()) formats += fmt::format("\n{}", importer.summary);
  command.add("FILE", options->file, "The file to read:" + formats).required();
  command.add("-o,--output", options->output, "The preset to write").type_name("PRESET");
  command.add("--name", options->name, "Which one, where the file has several");
  command.add_flag("--list", options->list, "Only print the names of what is in the file");
  command.add("--take", options->take, "What of it").one_of({"both", "colors", "opacities"}).shows_default();
  command.add("--onto", options->onto, "The preset that gives the rest")
      .type_name("PRESET")
      .offers(library_names());
  command.add("--volume", options->volume, "Write it in this volume's values and units")
      .type_name("VOLUME")
      .offers(builtin_sources());
  command.add_flag(
      "--fit", options->fit,
      "Lay its values over the range of --onto's points, or of the volume, as ParaView does with its maps");
  command.add_flag("--json", options->json, "Say on the standard output as JSON what was read");
  command.add_example("crest import CT-Bone.vp.json -o my.json");
  command.add_example("crest import presets.xml --list");
  command.when_read([options, command, &chosen] {
    command.prefer_typed("--output", {"--list"});
    if (options->onto.empty()) command.leave_out({"--take"});
    if (options->list && !options->output.empty())
      throw UsageError("--list", "prints names, and writes no --output");
    chosen = [options] { import_file(*options); };
  });
}

}  // namespace crest
