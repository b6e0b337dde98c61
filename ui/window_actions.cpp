#include <fmt/core.h>

#include <utility>

#include "presets/choices.h"
#include "ui/actions.h"
#include "ui/mode_text.h"
#include "ui/studio_state.h"

// The actions that lead to the panels, and to the help.

namespace crest {
namespace {

/// The mode in which the preset is rendered elsewhere.
std::vector<Action> mode_entries(const ActionContext&) {
  std::vector<Action> entries;
  for (const Mode mode : view_modes)
    entries.push_back(
        {.name = title_of(mode),
         .tip = explanation_of(mode),
         .checked = [mode](const ActionContext& c) { return c.document.preset.rendering.mode == mode; },
         .run =
             [mode](const ActionContext& c) {
               Rendering& rendering = c.document.preset.rendering;
               const Rendering before = std::exchange(rendering, in_mode(rendering, mode));
               return !(rendering == before);
             }});
  return entries;
}

}  // namespace

void add_window_actions(std::vector<Action>& table) {
  for (const char* const tab : tab_names)
    table.push_back({.name = fmt::format("Go to {}", tab),
                     .section = Section::panels,
                     .run = [tab](const ActionContext& c) {
                       c.state.asked_tab = tab;
                       return false;
                     }});
  table.push_back({.name = "Mode in the file",
                   .section = Section::panels,
                   .entries = mode_entries,
                   .lead = "Mode in the file: "});
  table.push_back({.name = "Keys and mouse",
                   .section = Section::help,
                   .key = {key::f1},
                   .run = [](const ActionContext& c) {
                     c.state.show_help = true;
                     return false;
                   }});
}

}  // namespace crest
