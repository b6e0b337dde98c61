#include <fmt/core.h>

#include "app/commands.h"
#include "app/sources.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/preset_file.h"
#include "render/files/load.h"
#include "render/volume/match_values.h"
#include "ui/edit_points.h"

namespace crest {
namespace {

struct MatchOptions {
  std::string preset, from, to, output, by = "histogram";
  bool json = false;
};

void match(const MatchOptions& options) {
  Preset preset = load_preset(options.preset);
  TransferFunction& tf = preset.transfer_function;
  const ValueDistribution from = distribution_of(load_volume(options.from)),
                          to = distribution_of(load_volume(options.to));
  const TransferFunction before = in_domain(tf, Domain::data, from.range);
  const TransferFunction after =
      carried(before, from, to, options.by == "range" ? CarryBy::range : CarryBy::histogram);
  tf = in_domain(after, tf.domain, to.range);
  save_preset(options.output, preset);
  if (!options.json) return;
  auto values = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < before.points.size(); ++i)
    values.push_back({{"from", before.points[i].value}, {"to", after.points[i].value}});
  fmt::print("{}", print_json({{"file", options.output}, {"values", values}}));
}

}  // namespace

void add_match_command(Options app, Action& chosen) {
  auto options = std::make_shared<MatchOptions>();
  Options command = app.add_command("match", "Carry a preset's transfer function from one volume to another",
                                    "Presets elsewhere");
  command.add("PRESET", options->preset, "A preset's file, or its name in the library")
      .required()
      .offers(library_names());
  command.add("--from", options->from, "The volume that it was made for")
      .required()
      .type_name("VOLUME")
      .offers(builtin_sources());
  command.add("--to", options->to, "The volume that it is to fit")
      .required()
      .type_name("VOLUME")
      .offers(builtin_sources());
  command.add("-o,--output", options->output, "The preset to write").required().type_name("PRESET");
  command
      .add("--by", options->by,
           "histogram: a value goes to that with as many voxels below it; range: by the ranges' ends")
      .one_of({"histogram", "range"})
      .shows_default();
  command.add_flag("--json", options->json, "Say on the standard output as JSON where each point went");
  command.add_example("crest match four-peaks --from builtin:noise --to builtin:gyroid -o gyroid.json");
  command.when_read([options, &chosen] { chosen = [options] { match(*options); }; });
}

}  // namespace crest
