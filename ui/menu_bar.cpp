#include "ui/menu_bar.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <algorithm>
#include <glm/common.hpp>
#include <numbers>
#include <string_view>
#include <utility>

#include "presets/exchange/color_maps.h"
#include "presets/names.h"
#include "render/scene/camera.h"
#include "render/volume/builtin.h"
#include "ui/camera_control.h"
#include "ui/comparison_view.h"
#include "ui/keys.h"
#include "ui/mode_text.h"
#include "ui/questions.h"
#include "ui/style.h"

namespace crest {
namespace {

bool item(StudioState& state, const char* text, const char* keys = nullptr, bool enabled = true) {
  const bool chosen = ImGui::MenuItem(text, keys, false, enabled);
  note_item(state.widgets, text);
  return chosen;
}

bool menu(StudioState& state, const char* text) {
  const bool open = ImGui::BeginMenu(text);
  note_item(state.widgets, fmt::format("menu/{}", text));
  return open;
}

void save(Document& document, StudioState& state, StudioRequests& requests) {
  if (document.preset_path.empty())
    ask_for_file(state, document, FilePurpose::save_preset);
  else
    requests.save_preset = document.preset_path;
}

bool undo(Document& document, StudioState& state) { return state.history.undo(document); }
bool redo(Document& document, StudioState& state) { return state.history.redo(document); }

void recent_files(StudioState& state, const StudioInputs& inputs, StudioRequests& requests, bool presets) {
  if (!menu(state, presets ? "Recent presets" : "Recent volumes")) return;
  bool any = false;
  for (const std::string& file : inputs.recent) {
    if (is_preset_name(file) != presets) continue;
    any = true;
    if (item(state, file.c_str())) (presets ? requests.open_preset : requests.open_volume) = file;
  }
  if (!any) ImGui::TextDisabled("none yet");
  ImGui::EndMenu();
}

void volume_menu(const Document& document, StudioState& state, const StudioInputs& inputs,
                 StudioRequests& requests) {
  if (!menu(state, "Volume")) return;
  if (item(state, "Open volume...", "Ctrl+O")) ask_for_file(state, document, FilePurpose::open_volume);
  recent_files(state, inputs, requests, false);
  if (menu(state, "Built-in")) {
    for (const Builtin& builtin : builtins()) {
      const std::string name(builtin.name);
      if (item(state, name.c_str())) requests.open_volume = "builtin:" + name;
      tip(std::string(builtin.summary).c_str());
    }
    ImGui::EndMenu();
  }
  if (item(state, "Close volume", nullptr, inputs.volume != nullptr)) requests.close_volume = true;
  ImGui::Separator();
  if (item(state, "Quit", "Ctrl+Q")) state.quit_asked = true;
  ImGui::EndMenu();
}

bool fit_to_volume(Document& document, StudioState& state, const Volume& volume) {
  TransferFunction& tf = document.preset.transfer_function;
  const TransferFunction before = std::exchange(tf, fitted(tf, volume.statistics.range));
  state.editor.visible.reset();
  return !(tf == before);
}

bool convert_domain(Document& document, StudioState& state, const Volume& volume) {
  TransferFunction& tf = document.preset.transfer_function;
  tf = in_domain(tf, tf.domain == Domain::data ? Domain::normalized : Domain::data, volume.statistics.range);
  state.editor.visible.reset();
  state.editor.new_peak_width.reset();
  return true;
}

/// The maps' colours on the points; those over 0..1 are laid over the points' range.
bool color_map_menu(Document& document, StudioState& state, const StudioInputs& inputs) {
  if (!menu(state, "Colours")) return false;
  bool changed = false;
  static const std::vector<ColorMap> maps = color_maps();
  TransferFunction& tf = document.preset.transfer_function;
  for (const ColorMap& map : maps) {
    const bool needs_volume = map.in_data_values && tf.domain == Domain::normalized;
    if (item(state, map.name.c_str(), nullptr, inputs.volume || !needs_volume)) {
      const ValueRange range = inputs.volume ? inputs.volume->statistics.range : ValueRange{};
      const TransferFunction before = std::exchange(tf, with_color_map(tf, map, range));
      changed |= !(tf == before);
    }
    tip(map.distinct.empty() ? (map.source + "\nlaid over the points; opacities stay").c_str()
                             : (map.source + "\na colour for each peak; opacities stay").c_str());
  }
  ImGui::EndMenu();
  return changed;
}

/// Each is of the TF as it was when the other volume was there, so that one can be tried after the other.
void carry_menu(StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  if (!inputs.carry_over || !menu(state, "Carry over")) return;
  ImGui::TextDisabled("the curve made for %s", inputs.carry_over->from.c_str());
  if (item(state, "By histogram", nullptr, inputs.carry_over->knows_values))
    requests.carry = CarryBy::histogram;
  tip("A value goes to that with as many voxels below it");
  if (item(state, "By the same places", nullptr, inputs.carry_over->same_grid))
    requests.carry = CarryBy::places;
  tip("By least squares: a value goes to what the volume has on average where the last one has the value.\n"
      "For two volumes of the same thing on the same grid");
  if (item(state, "By range")) requests.carry = CarryBy::range;
  tip("Least to least, greatest to greatest value");
  if (item(state, "As values")) requests.carry = CarryBy::value;
  tip("The same numbers");
  ImGui::EndMenu();
}

bool preset_menu(Document& document, StudioState& state, const StudioInputs& inputs,
                 StudioRequests& requests) {
  if (!menu(state, "Preset")) return false;
  bool changed = false;
  if (item(state, "New")) requests.new_preset = true;
  if (item(state, "Open preset...", "Ctrl+Shift+O")) ask_for_file(state, document, FilePurpose::open_preset);
  recent_files(state, inputs, requests, true);
  if (item(state, "Library...", "Ctrl+L")) state.library.asked = true;
  ImGui::Separator();
  if (item(state, "Save", "Ctrl+S")) save(document, state, requests);
  if (item(state, "Save as...", "Ctrl+Shift+S")) ask_for_file(state, document, FilePurpose::save_preset);
  if (item(state, "Export...", "Ctrl+E")) state.export_dialog.asked = true;
  if (item(state, "Name and notes...")) state.details.asked = true;
  ImGui::Separator();
  changed |= color_map_menu(document, state, inputs);
  carry_menu(state, inputs, requests);
  const bool normalized = document.preset.transfer_function.domain == Domain::normalized;
  if (item(state, "Fit to the volume's range", nullptr, inputs.volume != nullptr))
    changed |= fit_to_volume(document, state, *inputs.volume);
  if (item(state, normalized ? "Convert to data values" : "Convert to normalized values", nullptr,
           inputs.volume != nullptr))
    changed |= convert_domain(document, state, *inputs.volume);
  ImGui::EndMenu();
  return changed;
}

bool edit_menu(Document& document, StudioState& state) {
  if (!menu(state, "Edit")) return false;
  bool changed = false;
  const History& history = state.history;
  if (item(state, "Undo", "Ctrl+Z", history.can_undo(document))) changed |= undo(document, state);
  if (history.present() > 0) tip(history.steps()[history.present()].name.c_str());
  if (item(state, "Redo", "Ctrl+Shift+Z", history.can_redo())) changed |= redo(document, state);
  if (history.can_redo()) tip(history.steps()[history.present() + 1].name.c_str());
  ImGui::EndMenu();
  return changed;
}

/// Back to the whole volume. A turn of the wheel just before is a step of its own.
bool reset_view(Document& document, StudioState& state) {
  state.history.record(document);
  state.camera_moved = -1;
  const bool changed = document.preset.camera.has_value();
  document.preset.camera.reset();
  return changed;
}

/// Along an axis, or turned about the line of sight.
bool camera_menu(Document& document, StudioState& state, const StudioInputs& inputs) {
  if (!menu(state, "Look along")) return false;
  const glm::ivec2 shown = glm::max(state.picture_dialog.as_shown, glm::ivec2(1));
  const auto move = [&](const char* text, auto&& changed) {
    if (!item(state, text, nullptr, inputs.volume != nullptr)) return false;
    document.preset.camera = changed(camera_of(document.preset, inputs.volume->grid, aspect_of(shown)));
    return true;
  };
  bool changed = false;
  for (const auto& [text, direction] : {std::pair{"+X", glm::dvec3(1, 0, 0)},
                                        {"-X", glm::dvec3(-1, 0, 0)},
                                        {"+Y", glm::dvec3(0, 1, 0)},
                                        {"-Y", glm::dvec3(0, -1, 0)},
                                        {"+Z", glm::dvec3(0, 0, 1)},
                                        {"-Z", glm::dvec3(0, 0, -1)}})
    changed |= move(text, [&, to = direction](const Camera& camera) { return look_along(camera, to); });
  ImGui::Separator();
  constexpr double quarter = std::numbers::pi / 2;
  changed |= move("Roll to the right", [](const Camera& camera) { return roll(camera, quarter); });
  changed |= move("Roll to the left", [](const Camera& camera) { return roll(camera, -quarter); });
  ImGui::EndMenu();
  return changed;
}

void toggle_exact(ViewsState& views) {
  views.exact = !views.exact;
  views.error_bound = false;
}

void toggle_error_bound(ViewsState& views) {
  views.error_bound = !views.error_bound;
  views.exact |= views.error_bound;
}

void enlarge(ViewsState& views, int index) { views.enlarged = views.enlarged == index ? -1 : index; }

void show_views(ViewsState& views, int count) {
  views.count = count;
  views.enlarged = -1;
}

/// Esc goes back by one step: what is selected, what is compared, the view that fills the grid.
void go_back(StudioState& state) {
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

bool view_menu(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  if (!menu(state, "View")) return false;
  bool changed = false;
  if (item(state, "Save a picture...", "Ctrl+P", inputs.volume != nullptr)) state.picture_dialog.asked = true;
  ImGui::Separator();
  if (item(state, "Reset view", "R")) changed |= reset_view(document, state);
  changed |= camera_menu(document, state, inputs);
  ImGui::MenuItem("Outline and axes", nullptr, &state.views.outline);
  ImGui::MenuItem("Suggested peaks", nullptr, &state.editor.suggestions);
  note_item(state.widgets, "Suggested peaks");
  tip("Marks on the value axis where the volume's mean gradient is highest");
  if (ImGui::MenuItem("Exact at rest", "X", state.views.exact)) toggle_exact(state.views);
  note_item(state.widgets, "Exact at rest");
  tip("When nothing moves, each view goes on to the exact picture of its mode.\n"
      "Else it stays as the settings have it: step, classification, filter.");
  if (ImGui::MenuItem("Error bound", "B", state.views.error_bound)) toggle_error_bound(state.views);
  note_item(state.widgets, "Error bound");
  tip("How far each pixel of the exact picture may be off, in colours");
  ImGui::Separator();
  for (int i = 0; i < view_count; ++i) {
    const std::string text =
        fmt::format("View {} alone: {}", i + 1, title_of(state.views.contents[std::size_t(i)].mode));
    if (ImGui::MenuItem(text.c_str(), fmt::format("{}", i + 1).c_str(), state.views.enlarged == i))
      enlarge(state.views, i);
    note_item(state.widgets, fmt::format("view alone{}", i));
  }
  ImGui::Separator();
  static constexpr const char* counts[] = {"One view", "Two views", "Three views", "Four views"};
  for (int i = 1; i <= view_count; ++i) {
    if (ImGui::MenuItem(counts[i - 1], fmt::format("Ctrl+{}", i).c_str(),
                        state.views.enlarged < 0 && state.views.count == i))
      show_views(state.views, i);
    note_item(state.widgets, counts[i - 1]);
  }
  ImGui::Separator();
  if (item(state, "Reload shaders", "F5")) requests.reload_shaders = true;
  ImGui::EndMenu();
  return changed;
}

/// The preset's name at the right end, with a dot before it while it has changes that are not saved. A click
/// edits it.
void preset_name(const Document& document, StudioState& state, const StudioInputs& inputs) {
  const std::string& name = document.preset.name;
  const std::string file = document.preset_path.filename().string();
  const std::string text = !name.empty() ? name : !file.empty() ? file : "new preset";
  const float width = ImGui::CalcTextSize(text.c_str()).x + scaled(28);
  const float x = ImGui::GetWindowWidth() - width;
  if (x < ImGui::GetCursorPosX()) return;
  ImGui::SetCursorPosX(x);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (inputs.unsaved_changes)
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x, at.y + ImGui::GetFrameHeight() / 2}, scaled(4),
                                                palette::accent);
  ImGui::SetCursorPosX(x + scaled(10));
  ImGui::TextDisabled("%s", text.c_str());
  note_item(state.widgets, "preset title");
  if (ImGui::IsItemClicked()) state.details.asked = true;
  const std::string& notes = document.preset.notes;
  tip(fmt::format("{}{}{}Click for its name, notes and tags", inputs.unsaved_changes ? "Not saved yet\n" : "",
                  notes, notes.empty() ? "" : "\n")
          .c_str());
}

}  // namespace

bool menu_bar(Document& document, StudioState& state, const StudioInputs& inputs, StudioRequests& requests) {
  if (!ImGui::BeginMainMenuBar()) return false;
  bool changed = false;
  volume_menu(document, state, inputs, requests);
  changed |= preset_menu(document, state, inputs, requests);
  changed |= edit_menu(document, state);
  changed |= view_menu(document, state, inputs, requests);
  if (menu(state, "Help")) {
    if (item(state, "Keys and mouse", "F1")) state.show_help = true;
    ImGui::EndMenu();
  }
  preset_name(document, state, inputs);
  ImGui::EndMainMenuBar();
  return changed;
}

bool takes_typed_text() {
  const auto pressed = [](char letter) { return key_pressed(letter); };
  return ImGui::GetIO().KeyCtrl && std::ranges::any_of(std::string_view("SQOE"), pressed);
}

/// Whether a field is open in which nothing was typed yet.
bool only_opened(const WidgetState& widgets) {
  return ImGui::GetIO().WantTextInput && std::ranges::all_of(widgets.typed, [](const auto& typed) {
           return typed.second.text == typed.second.shown;
         });
}

bool shortcuts(Document& document, StudioState& state, const StudioInputs&, StudioRequests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return false;
  if (key_pressed(key_f1)) state.show_help = true;
  if (key_pressed(key_f5)) requests.reload_shaders = true;
  if (io.KeyCtrl) {
    if (key_pressed('O'))
      ask_for_file(state, document, io.KeyShift ? FilePurpose::open_preset : FilePurpose::open_volume);
    if (key_pressed('S') && io.KeyShift) ask_for_file(state, document, FilePurpose::save_preset);
    if (key_pressed('S') && !io.KeyShift) save(document, state, requests);
    if (key_pressed('L')) state.library.asked = true;
    if (key_pressed('E')) state.export_dialog.asked = true;
    if (key_pressed('P') && !io.KeyShift) state.picture_dialog.asked = true;
    if (key_pressed('Q')) state.quit_asked = true;
    for (int i = 1; i <= view_count; ++i)
      if (key_pressed('0' + i)) show_views(state.views, i);
    // A field that is being typed in has an undo of its own, and a drag is one step that is not over.
    if (ImGui::IsAnyItemActive()) {
      if (!only_opened(state.widgets)) return false;
      if (key_pressed('Z') || key_pressed('Y')) ImGui::ClearActiveID();
    }
    if (key_pressed('Z') && !io.KeyShift) return undo(document, state);
    if (key_pressed('Y') || key_pressed('Z')) return redo(document, state);
    return false;
  }
  if (io.WantTextInput) return false;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) && !ImGui::IsAnyItemActive())
    go_back(state);
  // Digits that are meant for a field that is not open yet are none for the views
  for (int i = 0; i < view_count && state.widgets.ahead.field == 0; ++i)
    if (key_pressed('1' + i)) enlarge(state.views, i);
  if (key_pressed('X')) toggle_exact(state.views);
  if (key_pressed('B')) toggle_error_bound(state.views);
  return key_pressed('R') && !ImGui::IsAnyMouseDown() && reset_view(document, state);
}

}  // namespace crest
