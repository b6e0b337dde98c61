#include <fmt/format.h>

#include <optional>

#include "app/commands.h"
#include "app/load_with_progress.h"
#include "app/sources.h"
#include "presets/error.h"
#include "presets/json.h"
#include "presets/preset_file.h"
#include "render/classify/classification.h"
#include "render/classify/peak_table.h"
#include "render/volume/every_nth_point.h"
#include "render/volume/filter_bounds.h"

namespace crest {
namespace {

struct PeaksOptions {
  std::string preset, volume;
  int bins = 0;     ///< 0: as the preset says
  int thinned = 0;  ///< 0: nobody asked
  bool json = true;
};

nlohmann::ordered_json peak_json(const Peak& peak) {
  return {{"value", peak.value},
          {"opacity", peak.opacity},
          {"color", {peak.color.r, peak.color.g, peak.color.b}},
          {"width", peak.width},
          {"prominence", peak.prominence},
          {"points", {peak.first_point, peak.last_point}},
          {"detected", peak.detected},
          {"shown", peak.shown},
          {"spike", peak.spike}};
}

/// The cells that have a candidate, one a line. Written as they come: 4096 bins have millions of them.
void print_table(const PeakTable& table, const std::vector<Peak>& surfaces) {
  fmt::print(
      R"(  "table": {{
    "bins": {},
    "range": [{}, {}],
    "largest_count": {},
    "cells": [)",
      table.bins, table.range.min, table.range.max, table.largest_count());
  const char* separator = "\n";
  for (int exit = 0; exit < table.bins; ++exit)
    for (int entry = 0; entry < table.bins; ++entry) {
      const int count = table.cell(entry, exit).count;
      if (count == 0) continue;
      std::vector<double> values;
      for (const int index : peaks_met(table, entry, exit))
        if (index >= 0) values.push_back(surfaces[std::size_t(index)].value);
      fmt::print(R"({}      {{"entry": {}, "exit": {}, "peaks": [{}], "count": {}}})", separator, entry, exit,
                 fmt::join(values, ", "), count);
      separator = ",\n";
    }
  fmt::print("\n    ]\n  }}\n");
}

/// What every n-th point would leave of each peak's surface; null where there is none.
void add_surface_left(const Volume& volume, int stride, const std::vector<Peak>& peaks,
                      nlohmann::ordered_json& json) {
  std::vector<double> values;
  for (const Peak& peak : peaks) values.push_back(peak.value);
  const auto left = surface_left(volume, stride, values);
  for (std::size_t i = 0; i < left.size(); ++i)
    json[i]["surface_left"] = left[i] ? nlohmann::ordered_json(*left[i]) : nlohmann::ordered_json();
}

void print_peaks(const PeaksOptions& options) {
  if (options.thinned > 0 && options.volume.empty()) throw UsageError("--thinned", "needs a --volume");
  const Preset preset = load_preset(options.preset);
  TransferFunction tf = preset.transfer_function;
  ValueRange range = tf.range();
  std::optional<Volume> volume;
  if (!options.volume.empty()) {
    volume = load_with_progress(options.volume);
    range = volume->statistics.range;
    tf = resolve(tf, range, volume->grid.smallest_spacing());
    range = field_range(root_filter(preset.rendering), range);
  }
  const int bins = options.bins > 0 ? options.bins : preset.rendering.peak_bins;
  const Classification found = classify(tf, range);
  auto peaks = nlohmann::ordered_json::array();
  for (const Peak& peak : found.peaks) peaks.push_back(peak_json(peak));
  if (options.thinned > 0) add_surface_left(*volume, options.thinned, found.peaks, peaks);
  const PeakTable table =
      build_peak_table(found.surfaces, range, bins);  // before anything is printed: it has a limit
  fmt::print("{{\n  \"peaks\": {},\n", peaks.dump());
  print_table(table, found.surfaces);
  fmt::print("}}\n");
}

}  // namespace

void add_peaks_command(Options app, Command& chosen) {
  auto options = std::make_shared<PeaksOptions>();
  Options command = app.add_command("peaks", "Print a preset's peaks and its peak table, as JSON", "Look");
  command.add("PRESET", options->preset, "A preset's file, or its name in the library")
      .required()
      .offers(library_names());
  command.add("--volume", options->volume, "Values and range of this volume; without it the TF's own points")
      .type_name("VOLUME")
      .offers(builtin_sources());
  command.add("--bins", options->bins, "Bins of the table; without it as the preset says").in(1, 4096);
  command
      .add("--thinned", options->thinned,
           "Add how much of each peak's surface every N-th point of the volume would leave (?stride=N)")
      .in(2, 64);
  command.add_flag("--json", options->json, "JSON is the only form there is");
  command.add_example("crest peaks four-peaks --volume builtin:gyroid --bins 64");
  command.when_read([options, command, &chosen] {
    if (options->volume.empty()) command.leave_out({"--thinned"});
    chosen = [options] { print_peaks(*options); };
  });
}

}  // namespace crest
