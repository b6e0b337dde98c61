#include "ui/view_caption.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "presets/choices.h"
#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/scene/exact.h"
#include "ui/actions.h"
#include "ui/comparison_view.h"
#include "ui/mode_text.h"
#include "ui/style.h"
#include "ui/warning_sign.h"

namespace crest {
namespace {

std::string cost_text(const ViewPicture& view) {
  if (view.frame_ms <= 0) return "";
  std::string text =
      view.frame_ms < 100 ? fmt::format("{:.1f} ms", view.frame_ms) : fmt::format("{:.0f} ms", view.frame_ms);
  if (view.is_exact && view.samples_per_ray > 0)
    text += fmt::format("   {:.1f} cells/ray", view.samples_per_ray);
  else if (view.samples_per_ray > 0)
    text += fmt::format("   {:.1f} samples/ray, {:.1f} DVR", view.samples_per_ray, view.dvr_samples_per_ray);
  return text;
}

/// Of an exact picture: how sure that is, and what it is of.
std::string exact_text(const ViewPicture& view, Mode mode, bool is_lit) {
  std::string sure;
  if (view.progress < 1)
    sure = "becoming exact";
  else if (!view.share_within)
    sure = "exact";
  else
    sure = fmt::format("exact, {:.4g} % surely within 1/255{}", std::floor(1e4 * *view.share_within) / 100,
                       is_lit ? " but for light" : "");
  return fmt::format("{}: {}", sure, exact_explanation_of(mode));
}

/// What the view shows, in one line, and more of it under the mouse.
void explanation(const Rendering& rendering, ShownPicture wanted, const ViewPicture& view) {
  const bool is_lit = takes_gradient(rendering.shading);
  const std::string text =
      view.is_exact ? exact_text(view, rendering.mode, is_lit) : explanation_of(rendering.mode);
  ImGui::PushStyleColor(ImGuiCol_Text, palette().secondary);
  ImGui::TextUnformatted(shortened(text, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleColor();
  std::string more = text;
  if (view.is_exact)
    more += fmt::format(
        "\nBy bounds on all errors along a ray, of a 64th of the pixels; light is not in them."
        "\n{} shows the picture as the settings have it, {} how far each pixel may be off.",
        key_text_of("Exact at rest"), key_text_of("Error bound"));
  else if (const std::string why_not = why_not_exact(rendering); !why_not.empty())
    more += "\nNot exact: " + why_not;
  else if (wanted == ShownPicture::as_set)
    more +=
        fmt::format("\nAs the settings have it; {} shows the exact picture.", key_text_of("Exact at rest"));
  tip(more.c_str());
}

template <class Value>
void option(WidgetState& widgets, const char* text, std::optional<Value>& now, std::optional<Value> value) {
  if (ImGui::MenuItem(text, nullptr, now == value)) now = value;
  note_item(widgets, text);
}

bool submenu(WidgetState& widgets, const char* text) {
  const bool open = ImGui::BeginMenu(text);
  note_item(widgets, text);
  return open;
}

/// What the view shows: its mode, and where it differs from the others.
void content_menu(int index, StudioState& state, const StudioInputs& inputs, const Preset& preset) {
  WidgetState& widgets = state.widgets;
  ViewContent& content = state.views.contents[std::size_t(index)];
  for (const Mode mode : view_modes) {
    if (ImGui::MenuItem(title_of(mode), nullptr, content.mode == mode)) content.mode = mode;
    note_item(widgets, fmt::format("show/{}", name_of(mode)));
    tip(fmt::format("{}\n{} in files", explanation_of(mode), name_of(mode)).c_str());
  }
  ImGui::Separator();
  if (submenu(widgets, "Engine")) {
    option<Engine>(widgets, "As the preset has it", content.engine, {});
    option<Engine>(widgets, "Ray caster", content.engine, Engine::raycaster);
    option<Engine>(widgets, "View-dependent layers (VDLS)", content.engine, Engine::vdls);
    ImGui::EndMenu();
  }
  if (submenu(widgets, "Picture")) {
    option<ShownPicture>(widgets, "As all views", content.picture, {});
    option<ShownPicture>(widgets, "As set", content.picture, ShownPicture::as_set);
    option<ShownPicture>(widgets, "Exact", content.picture, ShownPicture::exact);
    option<ShownPicture>(widgets, "How far it may be off", content.picture, ShownPicture::error_bound);
    ImGui::EndMenu();
  }
  if (submenu(widgets, "Preset")) {
    other_preset_menu(state, inputs, preset, content, {index, false});
    ImGui::EndMenu();
  }
}

/// Room for a triangle behind a button's text.
std::string with_arrow(const std::string& text) { return text + "    "; }

/// A button that opens the popup of its name, with a triangle that says so.
void popup_button(WidgetState& widgets, const std::string& text, const std::string& name) {
  if (ImGui::Button(fmt::format("{}##{}", with_arrow(text), name).c_str())) ImGui::OpenPopup(name.c_str());
  note_item(widgets, name);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float side = scaled(4), middle = (low.y + high.y) / 2, right = high.x - scaled(7);
  ImGui::GetWindowDrawList()->AddTriangleFilled({right - 2 * side, middle - side / 2},
                                                {right, middle - side / 2}, {right - side, middle + side / 2},
                                                palette().secondary);
}

}  // namespace

bool other_preset_menu(StudioState& state, const StudioInputs& inputs, const Preset& preset,
                       ViewContent& content, ViewPart part) {
  const auto before = content.other;
  // `source` is a file, or a name in the library
  const auto choose = [&](const std::string& text, const std::string& source, const std::string& name) {
    const std::string label = fmt::format("{}##{}", text, source);
    const bool chosen = ImGui::MenuItem(label.c_str(), nullptr, content.other && content.other->name == name);
    note_item(state.widgets, "other/" + source);
    if (!chosen) return;
    try {
      content.other = std::make_shared<const OtherPreset>(OtherPreset{name, load_preset(source)});
    } catch (const std::exception& error) {
      state.views.error = error.what();
    }
  };
  if (ImGui::IsWindowAppearing()) state.views.asks_for_own = true;
  if (ImGui::MenuItem("The one that is edited", nullptr, !content.other)) content.other = nullptr;
  note_item(state.widgets, "other/none");
  ImGui::Separator();
  for (const auto& snapshot : state.views.snapshots)
    if (ImGui::MenuItem(snapshot->name.c_str(), nullptr, content.other == snapshot)) content.other = snapshot;
  if (ImGui::MenuItem("Take a snapshot of it")) content.other = take_snapshot(state.views, preset);
  note_item(state.widgets, "take snapshot");
  ImGui::Separator();
  for (const LibraryPreset& one : library()) {
    const std::string name(one.name);
    choose(name, name, name);
  }
  bool any = false;
  for (const LibraryEntry& entry : inputs.library) {
    if (!entry.is_own()) continue;
    if (!std::exchange(any, true)) ImGui::Separator();
    choose(entry.title, entry.name, entry.title);
  }
  any = false;
  for (const std::string& file : inputs.recent) {
    if (!is_preset_name(file)) continue;
    if (!std::exchange(any, true)) ImGui::Separator();
    choose(file, file, file_name(file));
  }
  ImGui::Separator();
  if (ImGui::MenuItem("From a file...")) {
    state.views.preset_for = part;
    state.views.asks_for_file = true;
  }
  note_item(state.widgets, "other/file");
  return content.other != before;
}

void view_caption(int index, StudioState& state, const StudioInputs& inputs, const Preset& preset) {
  const ViewPicture& view = inputs.views[std::size_t(index)];
  const ViewContent& content = state.views.contents[std::size_t(index)];
  const float width = ImGui::GetContentRegionAvail().x, start = ImGui::GetCursorPosX(), gap = scaled(8);
  const float padding = 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, scaled(2)});
  ImGui::AlignTextToFramePadding();
  const bool enlarged = state.views.enlarged == index, compares = compares_view(state.views, index);
  const std::string name = fmt::format("content{}", index), compare = fmt::format("compare{}", index);

  const float sign = view.warnings.empty() ? 0 : gap + ImGui::GetFontSize();
  const float arrow = ImGui::CalcTextSize(with_arrow("").c_str()).x;
  const auto width_of = [&](const std::string& compare_text, const std::string& action) {
    return ImGui::CalcTextSize(with_arrow(compare_text).c_str()).x + ImGui::CalcTextSize(action.c_str()).x +
           2 * padding + scaled(4);
  };
  // Where the name would be cut, the buttons beside it have signs in place of words
  std::string compare_text = compares ? "comparing" : "compare", action = enlarged ? "restore" : "enlarge";
  const float named = ImGui::CalcTextSize(text_of(content).c_str()).x + padding + arrow;
  if (named + sign + gap + width_of(compare_text, action) > width) {
    compare_text = "vs";
    action = enlarged ? "-" : "+";
  }
  const float actions = width_of(compare_text, action);
  const float room = width - actions - gap - sign - padding - arrow;
  popup_button(state.widgets, shortened(text_of(content), std::max(room, scaled(24))), name);
  float left = ImGui::GetItemRectSize().x;
  tip(fmt::format("{}: {}\n{} in files. Click to choose what this view shows", text_of(content),
                  explanation_of(content.mode), name_of(content.mode))
          .c_str());
  if (ImGui::BeginPopup(name.c_str())) {
    content_menu(index, state, inputs, preset);
    ImGui::EndPopup();
  }
  if (!view.warnings.empty()) {
    ImGui::SameLine(0, gap);
    warning_sign(state.widgets, fmt::format("warning{}", index), view.warnings);
    left += gap + ImGui::GetItemRectSize().x;
  }

  const std::string cost = cost_text(view);
  const float cost_width = ImGui::CalcTextSize(cost.c_str()).x;
  if (!cost.empty() && left + gap + cost_width + gap + actions < width) {
    ImGui::SameLine(start + width - actions - gap - cost_width);
    ImGui::TextDisabled("%s", cost.c_str());
  }
  ImGui::SameLine(start + std::max(width - actions, left + gap));
  popup_button(state.widgets, compare_text, compare);
  tip("With another view, another preset, a snapshot or the exact picture:\nbehind a line to drag, as a "
      "difference, or one after the other");
  if (ImGui::BeginPopup(compare.c_str())) {
    comparison_menu(index, state, inputs, preset);
    ImGui::EndPopup();
  }
  ImGui::SameLine(0, scaled(4));
  if (ImGui::Button(action.c_str())) state.views.enlarged = enlarged ? -1 : index;
  note_item(state.widgets, fmt::format("enlarge{}", index));
  tip(enlarged ? "All views again (also: double-click, Esc)" : "This view alone (also: double-click)");
  ImGui::PopStyleVar();
  explanation(rendering_of(content, preset), content.picture.value_or(shown_by_all(state.views)), view);
}

}  // namespace crest
