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

bool go_to_next_area(const ActionContext& c) {
  NavigationState& navigation = c.state.navigation;
  navigation.asked = navigation.area == Area::views    ? Area::editor
                     : navigation.area == Area::editor ? Area::tabs
                                                       : Area::views;
  return false;
}

void add_help_actions(std::vector<Action>& table) {
  const auto add = [&](Action action) {
    action.section = Section::help;
    table.push_back(std::move(action));
  };
  add({.name = "Commands...",
       .key = ctrl_shift_and('P'),
       .takes_typed = true,
       .tip = "Find anything by its name",
       .run = [](const ActionContext& c) {
         c.state.palette.asked = true;
         return false;
       }});
  add({.name = "Keys and mouse", .key = {key::f1}, .run = [](const ActionContext& c) {
         c.state.show_help = true;
         return false;
       }});
  add({.name = "Menus", .key = {key::f10}, .tip = "Also: Alt alone", .run = [](const ActionContext& c) {
         c.state.navigation.asked_menu = true;
         return false;
       }});
  add({.name = "Next part of the window",
       .key = {key::f6},
       .takes_typed = true,
       .tip = "The views, the transfer function, the tabs",
       .run = go_to_next_area});
  add({.name = "Manual", .separated = true, .run = [](const ActionContext& c) {
         c.requests.open_manual = "";
         return false;
       }});
  add({.name = "About", .run = [](const ActionContext& c) {
         c.state.show_about = true;
         return false;
       }});
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
  add_help_actions(table);
}

}  // namespace crest
