#include <utility>

#include "ui/actions.h"
#include "ui/arrange_points.h"
#include "ui/clipboard.h"
#include "ui/edit_shown.h"
#include "ui/point_tools.h"
#include "ui/studio_state.h"
#include "ui/transfer_function_editor.h"

// The actions of the menu Edit, and those of the transfer function's editor.

namespace crest {
namespace {

TransferFunction& tf_of(const ActionContext& c) { return c.document.preset.transfer_function; }

std::string needs_selection(const ActionContext& c) {
  return c.state.editor.selection.empty() ? "no point is selected" : "";
}

ValueRange visible_values(const ActionContext& c) {
  return visible_values(tf_of(c), c.state.editor, c.inputs.volume);
}

bool paste(const ActionContext& c) {
  const ValueRange volume = c.inputs.volume ? c.inputs.volume->statistics.range : ValueRange{0, 1};
  return paste_points(tf_of(c), c.state.editor, volume, visible_values(c));
}

bool select_all(const ActionContext& c) {
  c.state.editor.selection = everything(tf_of(c));
  return false;
}

/// An action that works on the points as the editor shows them.
Action on_shown_values(Action action) {
  action.run = [run = std::move(action.run)](const ActionContext& c) {
    return in_shown_values(c.document, c.state, c.inputs, [&] { return run(c); });
  };
  return action;
}

void add_history_actions(std::vector<Action>& table) {
  const auto add = [&](Action action) {
    action.section = Section::edit;
    action.when = KeyWhen::untouched;
    table.push_back(std::move(action));
  };
  add({.name = "Undo",
       .key = ctrl_and('Z'),
       .detail =
           [](const ActionContext& c) {
             const History& history = c.state.history;
             return history.present() > 0 ? history.steps()[history.present()].name : std::string();
           },
       .why_not =
           [](const ActionContext& c) {
             return c.state.history.can_undo(c.document) ? "" : "there is nothing to take back";
           },
       .run = [](const ActionContext& c) { return c.state.history.undo(c.document); }});
  add({.name = "Redo",
       .key = ctrl_shift_and('Z'),
       .other_key = ctrl_and('Y'),
       .detail =
           [](const ActionContext& c) {
             const History& history = c.state.history;
             return history.can_redo() ? history.steps()[history.present() + 1].name : std::string();
           },
       .why_not =
           [](const ActionContext& c) { return c.state.history.can_redo() ? "" : "nothing was taken back"; },
       .run = [](const ActionContext& c) { return c.state.history.redo(c.document); }});
}

void add_point_actions(std::vector<Action>& table) {
  const auto add = [&](Action action) {
    action.section = Section::edit;
    action.when = KeyWhen::at_rest;
    table.push_back(on_shown_values(std::move(action)));
  };
  add({.name = "Cut",
       .key = ctrl_and('X'),
       .separated = true,
       .tip = "The selected points",
       .why_not = needs_selection,
       .run = [](const ActionContext& c) { return cut_points(tf_of(c), c.state.editor); }});
  add({.name = "Copy",
       .key = ctrl_and('C'),
       .tip = "The selected points, as JSON",
       .why_not = needs_selection,
       .run = [](const ActionContext& c) { return copy_points(tf_of(c), c.state.editor), false; }});
  add({.name = "Paste", .key = ctrl_and('V'), .tip = "Points of the clipboard", .run = paste});
  add({.name = "Delete",
       .key = {key::del},
       .other_key = {key::backspace},
       .tip = "The selected points",
       .why_not = needs_selection,
       .run = [](const ActionContext& c) { return delete_points(tf_of(c), c.state.editor); }});
  add({.name = "Select all", .key = ctrl_and('A'), .run = select_all});
}

void add_curve_actions(std::vector<Action>& table) {
  const auto add = [&](Action action) {
    action.section = Section::curve;
    action.when = KeyWhen::at_rest;
    table.push_back(on_shown_values(std::move(action)));
  };
  for (const auto& [shape, letter] : {std::pair{Shape::spike, int('P')},
                                      {Shape::tent, 0},
                                      {Shape::box, 0},
                                      {Shape::gaussian, 0},
                                      {Shape::ramp, 0},
                                      {Shape::step, int('S')}})
    add({.name = adding(shape),
         .key = {letter},
         .tip = "Where there is most room; its value can be typed at once",
         .run = [shape = shape](const ActionContext& c) {
           return add_shape(tf_of(c), c.state.editor, shape, visible_values(c));
         }});
  add({.name = "Zoom to the selected points",
       .key = {'F'},
       .tip = "All values while none is selected",
       .run = [](const ActionContext& c) {
         frame_selection(c.document, c.state.editor, c.inputs);
         return false;
       }});
  add({.name = "Show all values", .run = [](const ActionContext& c) {
         c.state.editor.visible.reset();
         return false;
       }});
}

}  // namespace

void add_edit_actions(std::vector<Action>& table) {
  add_history_actions(table);
  add_point_actions(table);
  add_curve_actions(table);
}

}  // namespace crest
