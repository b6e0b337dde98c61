#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "app/commands.h"
#include "app/offscreen_context.h"
#include "app/output_folder.h"
#include "app/progress.h"
#include "app/scene_options.h"
#include "app/stability_files.h"
#include "presets/error.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "render/reference/reference.h"
#include "render/studies/stability/table.h"

namespace crest {
namespace {

using stability::Row;
using stability::Verdict;

struct StabilityOptions {
  std::string size = "64x64", output;
  int device = -1;
  bool json = false;
};

void print_table(const std::vector<Row>& rows) {
  fmt::print("{:<20} {:<68} {:>9} {:>9}  {}\n", "group", "case", "bound", "measured", "verdict");
  for (const Row& row : rows)
    fmt::print("{:<20} {:<68} {:>9.2g} {:>9.2g}  {}\n", row.group, row.claim.name, row.claim.bound,
               row.measured, name_of(row.verdict));
}

/// All rows, with a progress bar. Throws Error when a stop is asked for.
std::vector<Row> measure_rows(Raycaster& raycaster, glm::ivec2 size, std::stop_token stop) {
  ProgressBar bar;
  const auto cases = stability::all_cases();
  stability::Lab lab{raycaster, size, std::move(stop)};
  try {
    return stability::run(lab, cases, [&](const stability::Case& next) {
      bar.show(double(&next - cases.data()) / double(cases.size()), next.name);
    });
  } catch (const Cancelled&) {
    throw Error("stopped before the table was done; nothing is written");
  }
}

glm::ivec2 square_pixels(const std::string& text) {
  const glm::ivec2 size = pixels_of(text);
  if (size.x != size.y || size.x < stability::least_side)
    throw UsageError("--size", fmt::format("'{}' is not a square of at least {}x{}", text,
                                           stability::least_side, stability::least_side));
  return size;
}

void run_stability(const StabilityOptions& options) {
  const glm::ivec2 size = square_pixels(options.size);
  const Interrupt interrupt;
  std::optional<OutputFolder> folder;
  if (!options.output.empty()) folder.emplace(options.output);
  const OffscreenContext context(options.device);
  Raycaster raycaster;
  const std::vector<Row> rows = measure_rows(raycaster, size, interrupt.token());
  const Json json = stability_json(rows, context.renderer());
  if (folder) write_stability(rows, json, options.output);
  if (options.json)
    fmt::print("{}\n", pretty(json));
  else
    print_table(rows);
  const auto failed = std::ranges::count(rows, Verdict::fail, &Row::verdict);
  if (failed > 0) throw Error(fmt::format("{} of {} cases do not keep their bound", failed, rows.size()));
}

}  // namespace

void add_stability_command(Options app, Command& chosen) {
  auto options = std::make_shared<StabilityOptions>();
  Options command =
      app.add_command("stability", "Stiff and extreme cases: what is kept, and what is not", "Measure");
  command.add("-o,--output", options->output, "The folder for stability.json and stability.html")
      .not_empty()
      .type_name("DIR");
  command.add("--size", options->size, "Width x height of its pictures, which are square")
      .shows_default()
      .type_name("WxH");
  command.add("--device", options->device, "Graphics device (crest list devices); hardware first by default")
      .in(0, 1000);
  command.add_flag("--json", options->json, "Print the table as JSON");
  command.add_example("crest stability -o stability");
  command.when_read([options, &chosen] { chosen = [options] { run_stability(*options); }; });
}

}  // namespace crest
