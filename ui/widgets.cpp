#include "ui/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "ui/keys.h"
#include "ui/style.h"

namespace crest {

bool escape_pressed(const WidgetState& state) {
  return key_pressed(key::escape) && !state.escape_taken && !ImGui::GetIO().WantTextInput;
}

std::string short_text(double value) { return fmt::format("{:.6g}", value == 0 ? 0.0 : value); }

namespace {

glm::dvec3 in_gamut(const float (&rgb)[3]) {
  return glm::clamp(glm::dvec3(rgb[0], rgb[1], rgb[2]), 0.0, 1.0);
}

}  // namespace

void note_item(WidgetState& state, std::string name) {
  state.items[std::move(name)] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
}

bool checkbox(WidgetState& state, const char* name, bool& value) {
  const bool changed = ImGui::Checkbox(name, &value);
  note_item(state, name);
  return changed;
}

bool slider(WidgetState& state, const char* name, double& value, ValueRange limits, float width) {
  ImGui::SetNextItemWidth(width);
  const double before = value;
  ImGui::SliderScalar(name, ImGuiDataType_Double, &value, &limits.min, &limits.max, "%.5g",
                      ImGuiSliderFlags_NoRoundToFormat | ImGuiSliderFlags_AlwaysClamp);
  note_item(state, name);
  return value != before;
}

bool color_square(WidgetState& state, const char* name, glm::dvec3& color) {
  float rgb[3] = {float(color.r), float(color.g), float(color.b)};
  const bool changed =
      ImGui::ColorEdit3(name, rgb, ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel);
  note_item(state, name);
  if (changed) color = in_gamut(rgb);
  return changed;
}

bool color_picker(const char* name, glm::dvec3& color) {
  float rgb[3] = {float(color.r), float(color.g), float(color.b)};
  if (!ImGui::ColorPicker3(name, rgb, ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview))
    return false;
  color = in_gamut(rgb);
  return true;
}

float choice_width(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetFrameHeight();
}

bool choice(WidgetState& state, const char* name, int& value, std::span<const std::string_view> names,
            float width) {
  const auto text_of = [&](std::size_t i) { return std::string(names[i]); };
  const std::size_t now = std::size_t(value);
  const std::string text = now < names.size() ? text_of(now) : "mixed";
  const bool has_room = choice_width(text) <= width || width <= 0;
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo(
      name, text.c_str(),
      ImGuiComboFlags_HeightLarge | (has_room ? ImGuiComboFlags_None : ImGuiComboFlags_NoArrowButton));
  note_item(state, name);
  if (!open) return false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (ImGui::Selectable(text_of(i).c_str(), i == now)) value = int(i);
    note_item(state, fmt::format("{}/{}", name, names[i]));
  }
  ImGui::EndCombo();
  return std::size_t(value) != now;
}

void heading(const char* text) {
  ImGui::PushFont(font_of(TextSize::heading));
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

void field_label(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", text);
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
}

void tip(const char* text) {
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

std::string shortened(const std::string& text, float room) {
  if (ImGui::CalcTextSize(text.c_str()).x <= room) return text;
  const auto is_inside = [&](std::size_t i) { return i < text.size() && (text[i] & 0xC0) == 0x80; };
  // Both ends, as long as can be: the beginning tells most
  std::string best = "...";
  for (std::size_t kept = 1; kept < text.size(); ++kept) {
    std::size_t front = (2 * kept + 2) / 3, back = text.size() - (kept - front);
    while (is_inside(front)) --front;  // a character of UTF-8 goes whole
    while (is_inside(back)) ++back;
    const std::string cut = text.substr(0, front) + "..." + text.substr(back);
    if (ImGui::CalcTextSize(cut.c_str()).x > room) break;
    best = cut;
  }
  return best;
}

void shortened_text(const std::string& text, float room, ImU32 color) {
  const std::string shown = shortened(text, room);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopStyleColor();
  if (shown != text) tip(text.c_str());
}

void text_on_picture(ImDrawList& list, ImVec2 at, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float pad = scaled(4);
  list.AddRectFilled({at.x - pad, at.y - pad / 2}, {at.x + size.x + pad, at.y + size.y + pad / 2},
                     palette().on_picture, pad);
  list.AddText(at, palette().text, text.c_str());
}

ImU32 packed(glm::dvec3 color, double alpha) {
  const auto byte = [](double v) { return v > 0 ? ImU32(std::lround(255 * std::min(v, 1.0))) : 0u; };
  return IM_COL32(byte(color.r), byte(color.g), byte(color.b), byte(alpha));
}

float scaled(float pixels) { return pixels * ImGui::GetFontSize() / 14; }

}  // namespace crest
