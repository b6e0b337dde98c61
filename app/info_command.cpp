#include <fmt/core.h>

#include "app/commands.h"
#include "app/load_with_progress.h"
#include "app/sources.h"
#include "presets/atomic_file.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "render/volume/by_value.h"
#include "render/volume/orientation.h"
#include "render/volume/suggested_peaks.h"

namespace crest {
namespace {

nlohmann::ordered_json triple(glm::dvec3 v) { return {v.x, v.y, v.z}; }

struct InfoOptions {
  std::string volume, by_value;  ///< where to; empty: not wanted
  int bins = 32;
  bool suggest_peaks = false, json = true;
};

std::string by_value_csv(const ByValue& by_value) {
  std::string csv = "from,to,volume,surface_area,mean_gradient,enclosed_volume\n";
  const std::vector<double> area = surface_area(by_value), mean = mean_gradient(by_value),
                            above = enclosed_volume(by_value);
  for (std::size_t i = 0; i < by_value.bins(); ++i) {
    const double from = by_value.range.min + double(i) * by_value.bin_width();
    csv += fmt::format("{},{},{},{},{},{}\n", from, from + by_value.bin_width(), by_value.volume[i], area[i],
                       mean[i], above[i]);
  }
  return csv;
}

nlohmann::ordered_json suggestions(const ByValue& by_value) {
  auto peaks = nlohmann::ordered_json::array();
  for (const SuggestedPeak& peak : suggest_peaks(by_value))
    peaks.push_back(
        {{"value", peak.value}, {"mean_gradient", peak.gradient}, {"persistence", peak.persistence}});
  return peaks;
}

void print_info(const InfoOptions& options) {
  require_other_files({{"--by-value", options.by_value}}, {options.volume});
  if (!options.by_value.empty()) require_writable(options.by_value);
  const Volume volume = load_with_progress(options.volume);
  const VolumeStatistics& statistics = volume.statistics;
  nlohmann::ordered_json json;
  json["name"] = volume.name;
  json["dims"] = {volume.grid.dims.x, volume.grid.dims.y, volume.grid.dims.z};
  json["type"] = name_of(volume.file_type);
  json["spacing"] = triple(volume.grid.spacing);
  json["origin"] = triple(volume.grid.origin);
  for (int column = 0; column < 3; ++column) json["direction"].push_back(triple(volume.direction[column]));
  if (const auto axes = anatomical_axes(volume))
    for (const AxisEnds& ends : *axes) json["axes"].push_back(fmt::format("{} to {}", ends.from, ends.to));
  json["range"] = {statistics.range.min, statistics.range.max};
  json["mean"] = statistics.mean;
  json["standard_deviation"] = std::sqrt(statistics.variance);
  json["voxels"] = volume.grid.point_count();
  json["nan"] = statistics.nan_count;
  json["inf"] = statistics.inf_count;
  if (volume.frames > 1) json["frames"] = volume.frames, json["frame"] = volume.frame;
  if (!volume.note.empty()) json["note"] = volume.note;
  json["histogram"] = histogram_of(volume.values, statistics.range, options.bins);
  if (options.suggest_peaks || !options.by_value.empty()) {
    const ByValue by_value = measure_by_value(volume).value();
    if (!options.by_value.empty()) write_file_atomically(options.by_value, by_value_csv(by_value));
    if (options.suggest_peaks) json["suggested_peaks"] = suggestions(by_value);
  }
  fmt::print("{}", print_json(json));
}

}  // namespace

void add_info_command(Options app, Command& chosen) {
  auto options = std::make_shared<InfoOptions>();
  Options command = app.add_command("info", "Print what a volume holds, as JSON", "Look");
  command.add("VOLUME", options->volume, "What to read (crest --help)").required().offers(builtin_sources());
  command.add("--bins", options->bins, "Bins of the histogram").in(1, 65536).shows_default();
  command
      .add("--by-value", options->by_value,
           "Write surface area, mean gradient and enclosed volume by value to this CSV file")
      .type_name("FILE.csv");
  command.add_flag("--suggest-peaks", options->suggest_peaks,
                   "Add the values at which the mean gradient is highest");
  command.add_flag("--json", options->json, "JSON is the only form there is");
  command.add_example("crest info head.nrrd --suggest-peaks --by-value head.csv");
  command.when_read([options, &chosen] { chosen = [options] { print_info(*options); }; });
}

}  // namespace crest
