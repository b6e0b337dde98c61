#include <cstdlib>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/offscreen_context.h"
#include "presets/error.h"
#include "render/stability/table.h"

namespace crest {
namespace {

struct StabilityOptions {
  std::string size = "64x64", output;
  bool json = false;
};

void run_stability(const StabilityOptions&) {
  const OffscreenContext context;
  Raycaster raycaster;
  stability::Lab lab{raycaster}; if (auto* e = std::getenv("STAB")) lab.size = glm::ivec2(std::atoi(e));
  const auto rows = stability::run_all(lab);
  for (const auto& row : rows) {
    fmt::print("{:<14} {:<64} {:9.2g} {:9.2g} {} {} {} {}\n", row.group, row.claim.name, row.claim.bound,
               row.measured, name_of(row.verdict), row.at, row.not_finite, row.covered); fmt::print("     left out {}\n", row.left_out);
    if (row.picture.pixels.empty()) fmt::print("   {}\n", row.claim.quantity);
  }
}

}  // namespace

void add_stability_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<StabilityOptions>();
  CLI::App* command =
      app.add_subcommand("stability", "Stiff and extreme cases: what is kept, and what is not");
  command->callback([options, &chosen] { chosen = [options] { run_stability(*options); }; });
}

}  // namespace crest
