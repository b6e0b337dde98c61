#include "ui/command_palette.h"

#include <fmt/core.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <set>

#include "ui/fuzzy_match.h"
#include "ui/number_field.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr std::size_t most_remembered = 30;
constexpr int rows_in_sight = 14;

std::vector<PaletteRow> all_rows(const ActionContext& context) {
  std::vector<PaletteRow> rows;
  for (const Action& action : actions()) {
    if (!action.entries) {
      rows.push_back({title_of(action, context), action.name, action, why_not(action, context)});
      continue;
    }
    for (const Action& entry : action.entries(context)) {
      const std::string name = action.lead + entry.name;
      rows.push_back({name, name, entry, why_not(entry, context)});
    }
  }
  // A built-in volume that was open is in two lists
  std::set<std::string> titles;
  std::erase_if(rows, [&](const PaletteRow& row) { return !titles.insert(row.title).second; });
  return rows;
}

/// How long ago it was chosen, in choices; the most for what never was.
std::size_t age(const PaletteState& palette, const PaletteRow& row) {
  return std::size_t(std::ranges::find(palette.chosen, row.name) - palette.chosen.begin());
}

void remember(PaletteState& palette, const std::string& name) {
  std::erase(palette.chosen, name);
  palette.chosen.insert(palette.chosen.begin(), name);
  if (palette.chosen.size() > most_remembered) palette.chosen.pop_back();
}

/// The key, or why not, at the right end of the last item.
void at_the_right(const std::string& text, ImU32 color) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float x = high.x - ImGui::CalcTextSize(text.c_str()).x - scaled(8);
  ImGui::GetWindowDrawList()->AddText({x, (low.y + high.y - ImGui::GetFontSize()) / 2}, color, text.c_str());
}

/// Returns whether it was chosen with the mouse.
bool show(const ActionContext& context, const PaletteRow& row, bool is_selected, bool comes_in_sight) {
  const bool enabled = row.why_not.empty();
  const bool is_on = row.action.checked && row.action.checked(context);
  const ImGuiSelectableFlags flags = enabled ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
  const std::string right = enabled ? key_text_of(row.action) : row.why_not;
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(right.c_str()).x -
                     (is_on ? scaled(72) : scaled(24));
  const std::string title = shortened(row.title, room);
  const std::string label = fmt::format("{}{}###{}", title, is_on ? "  (on)" : "", row.title);
  const bool clicked =
      ImGui::Selectable(label.c_str(), is_selected, flags | ImGuiSelectableFlags_DontClosePopups);
  note_item(context.state.widgets, "palette/" + row.title);
  if (is_selected && comes_in_sight) ImGui::SetScrollHereY(0.5F);
  if (title != row.title)
    tip(row.title.c_str());
  else if (!row.action.tip.empty())
    tip(row.action.tip.c_str());
  at_the_right(right, palette().secondary);
  return clicked;
}

/// Up and Down go round.
void move(PaletteState& palette, int count) {
  const int before = palette.selected;
  const auto pressed = [](int code) { return int(ImGui::IsKeyPressed(code)); };
  palette.selected += pressed(key::down) - pressed(key::up);
  if (count > 0) palette.selected = (palette.selected + count) % count;
  palette.selected += rows_in_sight * (pressed(key::page_down) - pressed(key::page_up));
  palette.selected = std::clamp(palette.selected, 0, std::max(count - 1, 0));
  palette.comes_in_sight |= palette.selected != before;
}

/// Whether Enter was pressed.
bool search_field(StudioState& state, bool appears) {
  constexpr const char* name = "##palette search";
  if (appears) open_next_field(state.widgets, name);
  keep_typed_ahead(state.widgets.ahead, ImGui::GetID(name));
  ImGui::SetNextItemWidth(-1);
  const std::string before = state.palette.typed;
  // Up and Down are the list's
  const bool entered =
      ImGui::InputTextWithHint(name, "What do you want to do?", &state.palette.typed,
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory,
                               [](ImGuiInputTextCallbackData*) { return 0; });
  note_item(state.widgets, "palette search");
  if (state.palette.typed != before) state.palette.selected = 0, state.palette.comes_in_sight = true;
  return entered;
}

std::optional<PaletteRow> chosen_row(const ActionContext& context, bool appears) {
  PaletteState& palette = context.state.palette;
  const std::string before = palette.typed;
  const bool entered = search_field(context.state, appears);
  if (appears || palette.typed != before) palette.rows = palette_rows(context, palette.typed);
  const std::vector<PaletteRow>& rows = palette.rows;
  move(palette, int(rows.size()));
  std::optional<PaletteRow> chosen;
  ImGui::BeginChild("rows", {0, rows_in_sight * ImGui::GetTextLineHeightWithSpacing()}, false,
                    ImGuiWindowFlags_NoNavInputs);
  for (int i = 0; i < int(rows.size()); ++i) {
    const PaletteRow& row = rows[std::size_t(i)];
    const bool is_selected = i == palette.selected;
    if (show(context, row, is_selected, palette.comes_in_sight) || (is_selected && entered)) chosen = row;
  }
  palette.comes_in_sight = false;
  if (rows.empty()) ImGui::TextDisabled("Nothing is called that");
  ImGui::EndChild();
  // The row may be older than what it says
  if (chosen && !why_not(chosen->action, context).empty()) {
    open_next_field(context.state.widgets, "##palette search");
    chosen.reset();
  }
  return chosen;
}

}  // namespace

std::vector<PaletteRow> palette_rows(const ActionContext& context, std::string_view typed) {
  const PaletteState& palette = context.state.palette;
  std::vector<PaletteRow> rows = all_rows(context);
  if (typed.find_first_not_of(' ') == typed.npos) {
    std::ranges::stable_sort(rows, {}, [&](const PaletteRow& row) { return age(palette, row); });
    return rows;
  }
  struct Found {
    bool can_be_done;
    int score;
    std::size_t length, row;
  };
  std::vector<Found> found;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (const auto score = match_score(typed, rows[i].title))
      found.push_back({rows[i].why_not.empty(), *score, rows[i].title.size(), i});
  std::ranges::stable_sort(found, [](const Found& a, const Found& b) {
    if (a.can_be_done != b.can_be_done) return a.can_be_done;
    return a.score != b.score ? a.score > b.score : a.length < b.length;
  });
  std::vector<PaletteRow> best;
  for (const Found& one : found) best.push_back(std::move(rows[one.row]));
  return best;
}

bool command_palette(const ActionContext& context) {
  constexpr const char* name = "Commands";
  PaletteState& palette = context.state.palette;
  if (palette.asked) {
    ImGui::OpenPopup(name);
    palette = {.chosen = std::move(palette.chosen)};
  }
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y * 0.12F}, ImGuiCond_Always, {0.5F, 0});
  ImGui::SetNextWindowSize({std::min(scaled(620), display.x * 0.9F), 0});
  if (!ImGui::BeginPopup(name)) return false;
  const std::optional<PaletteRow> chosen = chosen_row(context, ImGui::IsWindowAppearing());
  if (chosen || key_pressed(key::escape)) {
    ImGui::CloseCurrentPopup();
    context.state.widgets.escape_taken = true;
  }
  ImGui::EndPopup();
  if (!chosen) return false;
  remember(palette, chosen->name);
  return chosen->action.run(context);
}

}  // namespace crest
