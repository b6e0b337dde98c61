#include "ui/number_field.h"

#include <fmt/core.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/keys.h"
#include "ui/style.h"

namespace crest {
namespace {

/// The exact text where it fits into the field, or as many digits as do.
std::string fitting_text(double value, float width) {
  const std::string exact = exact_text(value);
  const float room = width - 2 * ImGui::GetStyle().FramePadding.x;
  if (ImGui::CalcTextSize(exact.c_str()).x <= room) return exact;
  std::string text;
  for (const int digits : {12, 10, 9, 8, 7, 6, 5, 4, 3}) {
    text = fmt::format("{:.{}g}", value, digits);
    if (ImGui::CalcTextSize(text.c_str()).x <= room) break;
  }
  return text;
}

float width_of_item(float width) {
  ImGui::SetNextItemWidth(width);
  return ImGui::CalcItemWidth();
}

/// Under the last item, over all that is there.
void show_reason(const std::string& why) {
  const ImVec2 pad{scaled(6), scaled(3)}, text = ImGui::CalcTextSize(why.c_str());
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float left =
      std::max(0.0F, std::min(ImGui::GetItemRectMin().x, display.x - text.x - 2 * pad.x - scaled(4)));
  const ImVec2 low{left, ImGui::GetItemRectMax().y + scaled(2)};
  const ImVec2 high{low.x + text.x + 2 * pad.x, low.y + text.y + 2 * pad.y};
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRectFilled(low, high, palette().plot, scaled(3));
  list.AddRect(low, high, palette().error, scaled(3));
  list.AddText({low.x + pad.x, low.y + pad.y}, palette().text, why.c_str());
}

std::string number_why_not(double value, const FieldRule& rule) {
  for (const FieldRule& each : {any_value, rule})
    if (const std::string why = why_outside(value, each); !why.empty())
      return fmt::format("{} {}", exact_text(value), why);
  return {};
}

}  // namespace

void keep_typed_ahead(TypedAhead& ahead, ImGuiID id) {
  if (ahead.field != id) return;
  ImVector<ImWchar>& queue = ImGui::GetIO().InputQueueCharacters;
  ahead.characters.insert(ahead.characters.end(), queue.begin(), queue.end());
  const bool is_ready = ImGui::GetActiveID() == id;
  queue.resize(0);
  if (is_ready)
    for (const ImWchar c : ahead.characters) queue.push_back(c);
  if (is_ready || --ahead.frames < 0) ahead = {};
}

void open_next_field(WidgetState& state, const char* name) {
  ImGui::SetKeyboardFocusHere();
  constexpr int frames_to_open = 10;
  state.ahead = {ImGui::GetID(name), {}, frames_to_open};
}

std::optional<NumberEdit> number_entry(WidgetState& state, const char* name, const std::string& shown,
                                       const std::function<std::string(const NumberEdit&)>& why_not,
                                       float width) {
  const ImGuiID id = ImGui::GetID(name);
  std::optional<RefusedNumber>& refused = state.refused;
  if (refused && refused->field == id && refused->shown != shown) refused.reset();  // it changed otherwise
  const bool is_refused = refused && refused->field == id;
  const auto found = state.typed.find(id);
  std::string text = found != state.typed.end() ? found->second.text : is_refused ? refused->text : shown;
  keep_typed_ahead(state.ahead, id);
  if (is_refused) ImGui::PushStyleColor(ImGuiCol_Text, palette().error);
  ImGui::SetNextItemWidth(width);
  ImGui::InputText(name, &text, ImGuiInputTextFlags_AutoSelectAll);
  note_item(state, name);
  if (is_refused) {
    ImGui::PopStyleColor();
    show_reason(refused->why);
    note_item(state, fmt::format("{}/refused", name));
    refused->is_shown = true;
  }
  if (ImGui::IsItemActive()) {
    note_item(state, "typing");
    state.typed.try_emplace(id, TypedText{{}, shown}).first->second.text = text;
    if (!state.take_typed) return std::nullopt;
    ImGui::ClearActiveID();
  }
  const auto typed = state.typed.find(id);
  if (typed == state.typed.end()) return std::nullopt;
  const std::string before = state.typed.extract(typed).mapped().shown;
  if (is_refused && text == refused->text && !key_pressed(key::escape)) return std::nullopt;
  if (is_refused) refused.reset();
  if (text == before || key_pressed(key::escape)) return std::nullopt;
  const TypedEdit read = read_edit(text);
  const std::string why = read.edit ? why_not(*read.edit) : read.wrong;
  if (why.empty()) {
    state.number_taken = true;
    return read.edit;
  }
  refused = RefusedNumber{id, text, why, shown, true};
  return std::nullopt;
}

bool number_field(WidgetState& state, const char* name, double& value, const FieldRule& rule, float width) {
  const auto edit = number_entry(
      state, name, fitting_text(value, width_of_item(width)),
      [&](const NumberEdit& e) { return number_why_not(e(value), rule); }, width);
  if (!edit) return false;
  const double before = value;
  value = (*edit)(before);
  return value != before;
}

bool integer_field(WidgetState& state, const char* name, int& value, int least, int most, float width) {
  const FieldRule rule{.min = double(least), .max = double(most)};
  const auto why_not = [&](const NumberEdit& edit) {
    const double number = edit(value);
    return number != std::trunc(number) ? fmt::format("{} is not a whole number", exact_text(number))
                                        : number_why_not(number, rule);
  };
  const auto edit = number_entry(state, name, fmt::format("{}", value), why_not, width);
  if (!edit) return false;
  const int before = value;
  value = int((*edit)(before));
  return value != before;
}

bool drag_field(WidgetState& state, const char* name, double& value, const FieldRule& rule, float width,
                const std::function<double(double from, double pixels)>& dragged) {
  const ImGuiID id = ImGui::GetID(name);
  FieldDrag& drag = state.drag;
  const bool is_refused = state.refused && state.refused->field == id;
  if (is_refused || drag.typed == id) {
    if (std::exchange(drag.begin_typing, false)) open_next_field(state, name);
    const bool changed = number_field(state, name, value, rule, width);
    if (ImGui::IsItemActive()) drag.frames = 0;
    if (!ImGui::IsItemActive() && --drag.frames < 0) drag.typed = 0;
    return changed;
  }
  const float room = width_of_item(width);
  ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0, 0.5F});
  const bool released =
      ImGui::Button(fmt::format("{}###{}", fitting_text(value, room), name).c_str(), {room, 0});
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  note_item(state, name);
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActivated()) drag.from = value, drag.moved = false;
  if (released && !drag.moved) drag.typed = id, drag.begin_typing = true, drag.frames = 3;
  if (!ImGui::IsItemActive()) return false;
  const float pixels = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 3).x;
  drag.moved |= pixels != 0;
  if (!drag.moved) return false;
  const double to = std::clamp(dragged(drag.from, double(pixels)), rule.min, rule.max);
  return std::exchange(value, to) != to;
}

std::string numbers_text(std::span<const double> values, float width) {
  const auto [least, most] = std::ranges::minmax(values);
  return least == most ? fitting_text(least, width_of_item(width))
                       : fmt::format("{} .. {}", short_text(least), short_text(most));
}

std::optional<NumberEdit> numbers_field(WidgetState& state, const char* name, std::span<const double> values,
                                        const FieldRule& rule, float width) {
  const auto why_not = [&](const NumberEdit& edit) {
    for (const double value : values)
      if (std::string why = number_why_not(edit(value), rule); !why.empty()) return why;
    return std::string();
  };
  return number_entry(state, name, numbers_text(values, width), why_not, width);
}

}  // namespace crest
