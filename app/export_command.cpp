#include <fmt/core.h>

#include <charconv>

#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/export_files.h"
#include "app/export_preview.h"
#include "app/load_with_progress.h"
#include "app/offscreen_context.h"
#include "app/scene_options.h"
#include "app/sources.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/exchange/exporters.h"
#include "presets/exchange/table.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/preset_file.h"
#include "presets/printable.h"
#include "render/scene/export_input.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

struct ExportCommandOptions {
  std::string preset, format, output, volume, samples = "auto", size = "1024x1024", preview;
  bool json = false;
};

int rows_of(const std::string& samples) {
  if (samples == "auto") return 0;
  int rows = 0;
  const auto [end, error] = std::from_chars(samples.data(), samples.data() + samples.size(), rows);
  if (error != std::errc() || end != samples.data() + samples.size() || rows < 2 || rows > most_table_rows)
    throw UsageError("--samples", fmt::format("{} is neither auto nor in [2, {}]", samples, most_table_rows));
  return rows;
}

void say(const Exporter& exporter, const Exported& exported, const std::optional<ExportPreview>& preview) {
  for (const std::string& sentence : exported.losses) fmt::print(stderr, "lost: {}\n", printable(sentence));
  for (const std::string& sentence : exported.advice) fmt::print(stderr, "there: {}\n", printable(sentence));
  if (preview)
    fmt::print(stderr,
               "preview: {} beside Crest: RMSE {:.3g}, largest difference {:.3g}, {:.3g} % of the pixels off "
               "by more than "
               "1/255\n",
               exporter.name, preview->rmse, preview->max, 100 * preview->share);
}

nlohmann::ordered_json to_json(const ExportCommandOptions& options, const ExportInput& input,
                               const Exported& exported, const std::optional<ExportPreview>& preview) {
  nlohmann::ordered_json json = {
      {"format", options.format}, {"losses", exported.losses}, {"advice", exported.advice}};
  if (preview)
    json["preview"] = {
        {"file", options.preview}, {"rmse", preview->rmse}, {"max", preview->max}, {"share", preview->share}};
  for (const ExportFile& file : exported.files)
    json["files"].push_back(path_of(options.output, input.stem, file).string());
  return json;
}

ExportPreview draw_preview(const ExportCommandOptions& options, const Exporter& exporter,
                           const ExportInput& input, const std::shared_ptr<const Volume>& volume) {
  const OffscreenContext context(-1);
  Renderer renderer({}, program_folder());
  const auto draw = [&](const Preset& p) {
    return draw_preset(renderer, p, volume, *input.preset.camera, input.size);
  };
  ExportPreview preview = compare_export(draw(input.preset), draw(exporter.as_drawn(input)));
  const glm::vec3 background(input.preset.rendering.background);
  write_image(options.preview, picture_of(preview, exporter.name, background), background);
  return preview;
}

void export_preset(const ExportCommandOptions& options) {
  const Exporter& exporter = find_exporter(options.format);
  if (!options.preview.empty() && options.volume.empty()) throw UsageError("--preview", "needs a --volume");
  require_other_files({{"--output", options.output}, {"--preview", options.preview}},
                      {options.preset, options.volume});
  require_writable(options.output);
  if (!options.preview.empty()) require_picture_file(options.preview);
  Preset preset = load_preset(options.preset);
  if (preset.name.empty()) preset.name = fs::path(options.preset).stem().string();
  std::shared_ptr<const Volume> volume;
  if (!options.volume.empty()) volume = std::make_shared<const Volume>(load_with_progress(options.volume));
  const ExportInput input =
      export_input(preset, volume.get(), rows_of(options.samples),
                   stem_of(options.output, exporter.extension), pixels_of(options.size));
  const Exported exported = exporter.write(input);
  std::vector<OutputFile> outputs;
  for (const ExportFile& file : exported.files)
    outputs.push_back({"--output", path_of(options.output, input.stem, file)});
  outputs.push_back({"--preview", options.preview});
  require_other_files(outputs, {options.preset, options.volume});
  std::optional<ExportPreview> preview;
  if (!options.preview.empty()) preview = draw_preview(options, exporter, input, volume);
  write_export(exported, input.stem, options.output);
  if (options.json)
    fmt::print("{}\n", pretty(to_json(options, input, exported, preview)));
  else
    say(exporter, exported, preview);  // when the work is done, so that an error stays a single line
}

}  // namespace

void add_export_command(Options app, Command& chosen) {
  auto options = std::make_shared<ExportCommandOptions>();
  Options command = app.add_command("export", "Write a preset for another program", "Presets elsewhere");
  std::string formats;
  std::vector<std::string> names;
  for (const Exporter& exporter : exporters()) {
    formats += fmt::format("{}: {}\n", exporter.name, exporter.summary);
    names.emplace_back(exporter.name);
  }
  command.add("PRESET", options->preset, "A preset's file, or its name in the library")
      .required()
      .offers(library_names());
  command.add("--to", options->format, formats + "One of").required().type_name("FORMAT").one_of(names);
  command.add("-o,--output", options->output, "The file to write").required().type_name("FILE");
  command
      .add("--volume", options->volume,
           "The volume for which it is written: gives a normalized preset values, scripts "
           "a file and a camera")
      .type_name("VOLUME")
      .offers(builtin_sources());
  command
      .add("--samples", options->samples, "Rows of a table; auto: the fewest that hold all points to 1/255")
      .type_name("N|auto")
      .shows_default();
  command.add("--size", options->size, "Of a script's picture, and of the preview")
      .type_name("WIDTHxHEIGHT")
      .shows_default();
  command
      .add("--preview", options->preview,
           "Also render it as the target will draw it, beside Crest's picture and their "
           "difference")
      .type_name("PICTURE");
  command.add_flag("--json", options->json,
                   "Say on the standard output as JSON what is lost, and what to do there");
  command.add_example("crest export my.json --to paraview-script --volume head.nrrd -o my.py");
  command.add_example("crest export smooth-haze --to csv --samples 256 --volume head.nrrd -o haze.csv");
  command.when_read([options, command, &chosen] {
    if (options->volume.empty()) command.leave_out({"--preview"});
    rows_of(options->samples);
    chosen = [options] { export_preset(*options); };
  });
}

}  // namespace crest
