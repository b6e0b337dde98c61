#include <fmt/core.h>

#include <glm/common.hpp>
#include <numbers>
#include <utility>

#include "render/scene/camera.h"
#include "ui/actions.h"
#include "ui/camera_control.h"
#include "ui/mode_text.h"
#include "ui/studio_state.h"

// The actions of the menu View.

namespace crest {
namespace {

/// Of a view, in pixels.
glm::ivec2 shown_size(const ActionContext& c) {
  return glm::max(c.state.picture_dialog.as_shown, glm::ivec2(1));
}

/// Back to the whole volume, in the same projection. A turn of the wheel just before is a step of its own.
bool reset_view(const ActionContext& c) {
  c.state.history.record(c.document);
  c.state.camera_moved = -1;
  std::optional<Camera>& camera = c.document.preset.camera;
  const std::optional<Camera> before = std::exchange(camera, std::nullopt);
  if (before && before->projection == Projection::parallel && c.inputs.volume)
    camera = whole_volume_camera(c.inputs.volume->grid, aspect_of(shown_size(c)), before->fov_y_degrees,
                                 Projection::parallel);
  return camera != before;
}

template <class Change>
Action camera_action(const char* name, Change change) {
  return {.name = name, .why_not = needs_volume, .run = [change](const ActionContext& c) {
            Preset& preset = c.document.preset;
            preset.camera = change(camera_of(preset, c.inputs.volume->grid, aspect_of(shown_size(c))));
            return true;
          }};
}

/// Along an axis, or turned about the line of sight.
std::vector<Action> camera_entries(const ActionContext&) {
  std::vector<Action> entries;
  for (const auto& [name, direction] : {std::pair{"+X", glm::dvec3(1, 0, 0)},
                                        {"-X", glm::dvec3(-1, 0, 0)},
                                        {"+Y", glm::dvec3(0, 1, 0)},
                                        {"-Y", glm::dvec3(0, -1, 0)},
                                        {"+Z", glm::dvec3(0, 0, 1)},
                                        {"-Z", glm::dvec3(0, 0, -1)}})
    entries.push_back(
        camera_action(name, [to = direction](const Camera& camera) { return look_along(camera, to); }));
  return entries;
}

void toggle_exact(ViewsState& views) {
  views.exact = !views.exact;
  views.error_bound = false;
}

void toggle_error_bound(ViewsState& views) {
  views.error_bound = !views.error_bound;
  views.exact |= views.error_bound;
}

/// Esc goes back by one step: what is selected, what is compared, the view that fills the grid.
void go_back(StudioState& state) {
  if (state.widgets.escape_taken) return;
  ViewsState& views = state.views;
  const int compared = views.comparison ? views.comparison->view : -1;
  const bool is_seen = views.enlarged >= 0 ? compared == views.enlarged : compared < views.count;
  if (!state.editor.selection.empty())
    state.editor.selection.clear();
  else if (compared >= 0 && is_seen)
    views.comparison.reset();
  else
    views.enlarged = -1;
}

void add(std::vector<Action>& table, Action action) {
  action.section = Section::view;
  table.push_back(std::move(action));
}

void add_camera_actions(std::vector<Action>& table) {
  add(table, {.name = "Reset view",
              .key = {'R'},
              .when = KeyWhen::at_rest,
              .separated = true,
              .tip = "The whole volume in view",
              .run = reset_view});
  add(table, {.name = "Look along", .entries = camera_entries, .lead = "Look along "});
  constexpr double quarter = std::numbers::pi / 2;
  add(table, camera_action("Roll to the right", [](const Camera& camera) { return roll(camera, quarter); }));
  add(table, camera_action("Roll to the left", [](const Camera& camera) { return roll(camera, -quarter); }));
  Action parallel = camera_action("Parallel projection", with_other_projection);
  parallel.key = {'O'};
  parallel.when = KeyWhen::at_rest;
  parallel.tip =
      "Without perspective: parallel edges stay parallel, and lengths can be compared.\n"
      "The wheel magnifies; what lies where you look stays as large when this is switched.";
  parallel.checked = [](const ActionContext& c) {
    const std::optional<Camera>& camera = c.document.preset.camera;
    return camera && camera->projection == Projection::parallel;
  };
  add(table, std::move(parallel));
}

void add_switches(std::vector<Action>& table) {
  const auto add_switch = [&](const char* name, const char* tip, bool ViewsState::*value,
                              void (*toggle)(ViewsState&), int letter) {
    add(table, {.name = name,
                .key = {letter},
                .when = KeyWhen::not_typing,
                .tip = tip,
                .checked = [value](const ActionContext& c) { return c.state.views.*value; },
                .run = [toggle](const ActionContext& c) { return toggle(c.state.views), false; }});
  };
  add_switch(
      "Outline and axes", "", &ViewsState::outline, [](ViewsState& views) { views.outline = !views.outline; },
      0);
  table.back().separated = true;
  add(table, {.name = "Suggested peaks",
              .tip = "Marks on the value axis where the volume's mean gradient is highest",
              .checked = [](const ActionContext& c) { return c.state.editor.suggestions; },
              .run =
                  [](const ActionContext& c) {
                    c.state.editor.suggestions = !c.state.editor.suggestions;
                    return false;
                  }});
  add_switch("Exact at rest",
             "When nothing moves, each view goes on to the exact picture of its mode.\n"
             "Else it stays as the settings have it: step, classification, filter.",
             &ViewsState::exact, toggle_exact, 'X');
  add_switch("Error bound", "How far each pixel of the exact picture may be off, in colours",
             &ViewsState::error_bound, toggle_error_bound, 'B');
}

std::string needs_steps(const ActionContext& c) {
  return c.inputs.steps ? "" : "the volume has no time steps";
}

void add_step_actions(std::vector<Action>& table) {
  const auto add_step = [&](const char* name, int letter, int by) {
    add(table, {.name = name,
                .key = {letter},
                .when = KeyWhen::not_typing,
                .separated = by < 0,
                .why_not = needs_steps,
                .run = [by](const ActionContext& c) {
                  const ShownSteps& steps = *c.inputs.steps;
                  c.requests.go_to_step = glm::clamp(steps.wanted + by, 0, steps.count - 1);
                  return false;
                }});
  };
  add_step("Previous time step", ',', -1);
  add_step("Next time step", '.', 1);
  add(table, {.name = "Play time steps",
              .key = {'T'},
              .when = KeyWhen::not_typing,
              .tip = "Step after step as they are read, ten a second at most",
              .why_not = needs_steps,
              .checked = [](const ActionContext& c) { return c.inputs.steps && c.inputs.steps->is_playing; },
              .run =
                  [](const ActionContext& c) {
                    c.requests.play_steps = !c.inputs.steps->is_playing;
                    return false;
                  }});
}

void add_grid_actions(std::vector<Action>& table) {
  for (int i = 0; i < view_count; ++i)
    add(table, {.name = fmt::format("View {} alone", i + 1),
                .key = {'1' + i},
                .when = KeyWhen::not_typing,
                .separated = i == 0,
                .detail =
                    [i](const ActionContext& c) {
                      return std::string(title_of(c.state.views.contents[std::size_t(i)].mode));
                    },
                .checked = [i](const ActionContext& c) { return c.state.views.enlarged == i; },
                .run =
                    [i](const ActionContext& c) {
                      int& enlarged = c.state.views.enlarged;
                      enlarged = enlarged == i ? -1 : i;
                      return false;
                    }});
  static constexpr const char* names[] = {"One view", "Two views", "Three views", "Four views"};
  for (int i = 1; i <= view_count; ++i)
    add(table,
        {.name = names[i - 1],
         .key = ctrl_and('0' + i),
         .separated = i == 1,
         .checked =
             [i](const ActionContext& c) { return c.state.views.enlarged < 0 && c.state.views.count == i; },
         .run =
             [i](const ActionContext& c) {
               c.state.views.count = i;
               c.state.views.enlarged = -1;
               return false;
             }});
}

}  // namespace

void add_view_actions(std::vector<Action>& table) {
  add(table, {.name = "Save a picture...",
              .key = ctrl_and('P'),
              .tip = "Or one turn, as pictures",
              .run = [](const ActionContext& c) {
                c.state.picture_dialog.asked = true;
                return false;
              }});
  add_camera_actions(table);
  add_switches(table);
  add_grid_actions(table);
  add_step_actions(table);
  add(table, {.name = "Back",
              .key = {key::escape},
              .when = KeyWhen::at_rest,
              .separated = true,
              .tip = "From the selection, a comparison, a view that fills the grid",
              .run = [](const ActionContext& c) { return go_back(c.state), false; }});
  add(table, {.name = "Settings...",
              .tip = "Dark or light, the size of texts and controls",
              .run = [](const ActionContext& c) {
                c.state.settings_asked = true;
                return false;
              }});
  add(table, {.name = "Reload shaders", .key = {key::f5}, .run = [](const ActionContext& c) {
                c.requests.reload_shaders = true;
                return false;
              }});
}

}  // namespace crest
