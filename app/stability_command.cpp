#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands.h"
#include "app/offscreen_context.h"
#include "app/output_folder.h"
#include "app/progress.h"
#include "app/report/page.h"
#include "app/scene_options.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "render/stability/table.h"

namespace crest {
namespace {

namespace fs = std::filesystem;
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

nlohmann::ordered_json json_of(const std::vector<Row>& rows, const std::string& renderer) {
  nlohmann::ordered_json json = {{"renderer", renderer}, {"rows", nlohmann::ordered_json::array()}};
  for (const Row& row : rows) {
    nlohmann::ordered_json item = {{"group", row.group},
                                   {"case", row.claim.name},
                                   {"quantity", row.claim.quantity},
                                   {"truth", name_of(row.claim.truth)},
                                   {"bound", row.claim.bound},
                                   {"measured", row.measured},
                                   {"verdict", name_of(row.verdict)},
                                   {"worst_at", row.at},
                                   {"pixels_not_finite", row.not_finite},
                                   {"pixels_covered", row.covered},
                                   {"pixels_grazing", row.left_out}};
    if (row.claim.limit)
      item["limit"] = {{"bound", row.claim.limit->bound},
                       {"why", row.claim.limit->why},
                       {"warnings", row.claim.limit->warnings}};
    json["rows"].push_back(std::move(item));
  }
  return json;
}

/// The pictures go into the page and nowhere else.
void write_stability_page(const fs::path& folder, const std::vector<Row>& rows, nlohmann::ordered_json data) {
  const fs::path picture = folder / ".picture.png";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].picture.pixels.empty()) continue;
    write_image(picture, rows[i].picture, glm::vec3(0));
    data["rows"][i]["picture"] = data_address(picture);
  }
  fs::remove(picture);
  write_page(folder / "stability.html", "Stiff and extreme cases", web_file("stability.html"),
             web_file("stability.js"), data);
}

std::vector<Row> measure_rows(stability::Lab& lab) {
  ProgressBar bar;
  std::size_t done = 0;
  const auto count = double(stability::all_cases().size());
  return stability::run_all(lab,
                            [&](const stability::Case& one) { bar.show(double(done++) / count, one.name); });
}

void run_stability(const StabilityOptions& options) {
  PictureOptions picture;
  picture.size = options.size;
  const glm::ivec2 size = picture.pixels();
  std::optional<OutputFolder> folder;
  if (!options.output.empty()) folder.emplace(options.output);
  const OffscreenContext context(options.device);
  Raycaster raycaster;
  stability::Lab lab{raycaster, size};
  const std::vector<Row> rows = measure_rows(lab);
  const auto json = json_of(rows, context.renderer());
  if (options.json)
    fmt::print("{}\n", json.dump(2));
  else
    print_table(rows);
  if (!options.output.empty()) {
    write_file_atomically(fs::path(options.output) / "stability.json", json.dump(2) + "\n");
    write_stability_page(options.output, rows, json);
  }
  const auto failed = std::ranges::count(rows, Verdict::fail, &Row::verdict);
  if (failed > 0) throw Error(fmt::format("{} of {} cases do not keep their bound", failed, rows.size()));
}

}  // namespace

void add_stability_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<StabilityOptions>();
  CLI::App* command =
      app.add_subcommand("stability", "Stiff and extreme cases: what is kept, and what is not");
  command->add_option("-o,--output", options->output, "The folder for stability.json and stability.html")
      ->type_name("DIR");
  command->add_option("--size", options->size, "Width x height of its pictures")
      ->capture_default_str()
      ->type_name("WxH");
  command->add_option("--device", options->device,
                      "Graphics device (crest list devices); hardware first by default");
  command->add_flag("--json", options->json, "Print the table as JSON");
  command->callback([options, &chosen] { chosen = [options] { run_stability(*options); }; });
}

}  // namespace crest
