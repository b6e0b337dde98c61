#include <fmt/core.h>

#include "app/commands.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "render/files/load.h"

namespace crest {
namespace {

nlohmann::ordered_json triple(glm::dvec3 v) { return {v.x, v.y, v.z}; }

void print_info(const std::string& source, int bins) {
  const Volume volume = load_volume(source);
  const VolumeStatistics& statistics = volume.statistics;
  nlohmann::ordered_json json;
  json["name"] = volume.name;
  json["dims"] = {volume.grid.dims.x, volume.grid.dims.y, volume.grid.dims.z};
  json["type"] = name_of(volume.file_type);
  json["spacing"] = triple(volume.grid.spacing);
  json["origin"] = triple(volume.grid.origin);
  for (int column = 0; column < 3; ++column) json["direction"].push_back(triple(volume.direction[column]));
  json["range"] = {statistics.range.min, statistics.range.max};
  json["mean"] = statistics.mean;
  json["standard_deviation"] = std::sqrt(statistics.variance);
  json["voxels"] = volume.grid.point_count();
  json["nan"] = statistics.nan_count;
  json["inf"] = statistics.inf_count;
  if (!volume.note.empty()) json["note"] = volume.note;
  json["histogram"] = histogram_of(volume.values, statistics.range, bins);
  fmt::print("{}", print_json(json));
}

}  // namespace

void add_info_command(Options app, Action& chosen) {
  struct InfoOptions {
    std::string volume;
    int bins = 32;
    bool json = true;
  };
  auto options = std::make_shared<InfoOptions>();
  Options command = app.add_command("info", "Print what a volume holds, as JSON");
  command.add("VOLUME", options->volume, "What to read (crest --help)").required();
  command.add("--bins", options->bins, "Bins of the histogram").in(1, 65536).shows_default();
  command.add_flag("--json", options->json, "JSON is the only form there is");
  command.when_read(
      [options, &chosen] { chosen = [options] { print_info(options->volume, options->bins); }; });
}

}  // namespace crest
