#include <utility>

#include "ui/actions.h"
#include "ui/comparison_view.h"
#include "ui/mode_text.h"
#include "ui/studio_state.h"

// The actions that compare a view: the one that is compared already, or fills the grid, or the first one.

namespace crest {
namespace {

int subject(const ViewsState& views) {
  return views.enlarged >= 0 ? views.enlarged : views.comparison ? views.comparison->view : 0;
}

/// With what it is compared with already, or the next view.
bool compare(ViewsState& views, ComparisonKind kind) {
  const int view = subject(views);
  if (!compares_view(views, view)) {
    const int next = (view + 1) % view_count;
    choose_other(views, view, views.contents[std::size_t(next)], next);
  }
  views.comparison->kind = kind;
  return false;
}

bool compare_with_snapshot(const ActionContext& c) {
  ViewsState& views = c.state.views;
  const int view = subject(views);
  ViewContent with = views.contents[std::size_t(view)];
  with.other = take_snapshot(views, c.document.preset);
  choose_other(views, view, with);
  return false;
}

}  // namespace

void add_compare_actions(std::vector<Action>& table) {
  const auto add = [&](Action action) {
    action.section = Section::compare;
    table.push_back(std::move(action));
  };
  for (const auto& [name, kind] :
       {std::pair{"Compare by a line to drag", ComparisonKind::divider},
        {"Compare by the difference", ComparisonKind::difference},
        {"Compare by the difference with its sign", ComparisonKind::signed_difference},
        {"Compare one after the other", ComparisonKind::blink}})
    add({.name = name,
         .tip = "The view that is compared, fills the grid or is the first one, with the next one",
         .why_not = needs_volume,
         .checked =
             [kind = kind](const ActionContext& c) {
               const auto& comparison = c.state.views.comparison;
               return comparison && comparison->kind == kind;
             },
         .run = [kind = kind](const ActionContext& c) { return compare(c.state.views, kind); }});
  add({.name = "Compare with a snapshot, taken now",
       .tip = "Go on editing, and see what it changes",
       .why_not = needs_volume,
       .run = compare_with_snapshot});
  add({.name = "Stop comparing",
       .why_not =
           [](const ActionContext& c) { return c.state.views.comparison ? "" : "nothing is compared"; },
       .run =
           [](const ActionContext& c) {
             c.state.views.comparison.reset();
             return false;
           }});
  add({.name = "Take a snapshot",
       .tip = "Of the preset, to compare with later",
       .run = [](const ActionContext& c) {
         take_snapshot(c.state.views, c.document.preset);
         return false;
       }});
}

}  // namespace crest
