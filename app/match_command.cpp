#include <fmt/core.h>

#include "app/commands.h"
#include "app/load_with_progress.h"
#include "app/sources.h"
#include "presets/atomic_file.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/preset_file.h"
#include "render/volume/fit_values.h"
#include "render/volume/match_values.h"
#include "ui/edit_points.h"

namespace crest {
namespace {

struct MatchOptions {
  std::string preset, from, to, output, by = "histogram";
  bool json = false;
};

struct Carried {
  TransferFunction before, after;  ///< in data values
  ValueRange to;                   ///< the other volume's
  std::optional<ValueFit> fit;     ///< of least squares
};

Carried carry(const TransferFunction& tf, const MatchOptions& options) {
  Carried carry;
  if (options.by == "least-squares") {
    const Volume from = load_with_progress(options.from), to = load_with_progress(options.to);
    carry.before = in_domain(tf, Domain::data, from.statistics.range);
    carry.to = to.statistics.range;
    carry.fit = fit_values(from, to);
    carry.after = carried(carry.before, *carry.fit);
    return carry;
  }
  const ValueDistribution from = distribution_of(load_with_progress(options.from)),
                          to = distribution_of(load_with_progress(options.to));
  carry.before = in_domain(tf, Domain::data, from.range);
  carry.to = to.range;
  carry.after = carried(carry.before, from, to, options.by == "range" ? CarryBy::range : CarryBy::histogram);
  return carry;
}

void match(const MatchOptions& options) {
  require_other_files({{"--output", options.output}}, {options.preset, options.from, options.to});
  require_writable(options.output);  // before the volumes are read
  Preset preset = load_preset(options.preset);
  TransferFunction& tf = preset.transfer_function;
  const Carried carried = carry(tf, options);
  tf = in_domain(carried.after, tf.domain, carried.to);
  save_preset(options.output, preset);
  if (!options.json) return;
  auto values = nlohmann::ordered_json::array();
  const std::size_t count = carried.before.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t to = carried.fit && carried.fit->is_decreasing ? count - 1 - i : i;
    values.push_back({{"from", carried.before.points[i].value}, {"to", carried.after.points[to].value}});
  }
  nlohmann::ordered_json report{{"file", options.output}, {"values", values}};
  if (carried.fit) report["explained"] = carried.fit->explained;
  fmt::print("{}", print_json(report));
}

}  // namespace

void add_match_command(Options app, Command& chosen) {
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
           "histogram: a value goes to that with as many voxels below it; range: by the ranges' ends; "
           "least-squares: by what both have at the same places of one grid")
      .one_of({"histogram", "range", "least-squares"})
      .shows_default();
  command.add_flag("--json", options->json, "Say on the standard output as JSON where each point went");
  command.add_example("crest match four-peaks --from builtin:noise --to builtin:gyroid -o gyroid.json");
  command.when_read([options, &chosen] { chosen = [options] { match(*options); }; });
}

}  // namespace crest
