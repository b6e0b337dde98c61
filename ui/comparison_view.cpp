#include "ui/comparison_view.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "presets/preset_file.h"
#include "render/scene/exact.h"
#include "ui/actions.h"
#include "ui/style.h"
#include "ui/view_caption.h"

namespace crest {
namespace {

constexpr std::size_t most_snapshots = 16;
constexpr float divider_reach = 7;  // pixels to either side

ImTextureID id_of(std::uintptr_t texture) { return reinterpret_cast<ImTextureID>(texture); }

void draw_divided(ImDrawList& list, const Comparison& comparison, std::uintptr_t left, std::uintptr_t right,
                  ImVec2 low, ImVec2 size) {
  const float share = comparison.divider, x = low.x + std::floor(size.x * share);
  list.AddImage(id_of(left), low, {x, low.y + size.y}, {0, 0}, {share, 1});
  list.AddImage(id_of(right), {x, low.y}, {low.x + size.x, low.y + size.y}, {share, 0}, {1, 1});
  list.AddLine({x, low.y}, {x, low.y + size.y}, IM_COL32_WHITE, 1);
  const float middle = low.y + size.y / 2, grip = scaled(5);
  list.AddCircleFilled({x, middle}, grip, palette().accent);
  list.AddCircle({x, middle}, grip, IM_COL32_WHITE);
}

/// What black and white stand for.
std::string scale_text(const Comparison& comparison) {
  return comparison.kind == ComparisonKind::difference
             ? fmt::format("black: the same, full: {:.3g}", 1 / comparison.amplification)
             : fmt::format("grey: the same, black and white: -+{:.3g}", 1 / comparison.amplification);
}

std::string numbers_text(const DifferencePicture& difference) {
  if (difference.has_failed) return "It could not be measured";
  if (!difference.is_measured) return "Measuring ...";
  return fmt::format("RMSE {:.2e}, at most {:.3g}, {:.2f} % off by more than 1/255", difference.rmse,
                     difference.max, 100 * difference.share);
}

void draw_difference(ImDrawList& list, StudioState& state, const DifferencePicture& difference,
                     std::uintptr_t own, ImVec2 low, ImVec2 high) {
  const bool is_there = difference.texture != 0;
  list.AddImage(id_of(is_there ? difference.texture : own), low, high);
  const std::string numbers = is_there ? numbers_text(difference) : "The difference, when both are done";
  const std::string scale = is_there ? scale_text(*state.views.comparison) + "\n" : "";
  text_on_picture(list, {low.x + scaled(10), high.y - 2 * ImGui::GetFontSize() - scaled(24)},
                  scale + numbers);
  note_item(state.widgets, "difference: " + numbers);
}

void other_items(int index, StudioState& state, const StudioInputs& inputs, const Preset& preset) {
  ViewsState& views = state.views;
  const ViewContent& own = views.contents[std::size_t(index)];
  const auto item = [&](const std::string& text, const std::string& name, const ViewContent& with,
                        std::optional<int> follows = {}) {
    const bool is_chosen = compares_view(views, index) && views.comparison->follows == follows &&
                           (follows || views.comparison->with == with);
    if (ImGui::MenuItem(text.c_str(), nullptr, is_chosen)) choose_other(views, index, with, follows);
    note_item(state.widgets, name);
  };
  for (int i = 0; i < view_count; ++i)
    if (i != index)
      item(fmt::format("View {}: {}", i + 1, text_of(views.contents[std::size_t(i)])),
           fmt::format("with view{}", i), views.contents[std::size_t(i)], i);
  ViewContent exact = own, as_set = own;
  exact.picture = ShownPicture::exact;
  as_set.picture = ShownPicture::as_set;
  const bool has_exact = why_not_exact(rendering_of(own, preset)).empty();
  const ShownPicture shown = own.picture.value_or(shown_by_all(views));
  if (has_exact && shown != ShownPicture::exact) item("Its exact picture", "with exact", exact);
  if (has_exact && shown != ShownPicture::as_set) item("Its picture as set", "with as set", as_set);
  if (ImGui::BeginMenu("Another preset")) {
    ViewContent other = compares_view(views, index) ? views.comparison->with : own;
    if (other_preset_menu(state, inputs, preset, other, {index, true})) choose_other(views, index, other);
    ImGui::EndMenu();
  }
  note_item(state.widgets, "with preset");
  if (ImGui::MenuItem("A snapshot, taken now")) {
    ViewContent other = own;
    other.other = take_snapshot(views, preset);
    choose_other(views, index, other);
  }
  note_item(state.widgets, "with snapshot");
  tip("Go on editing, and see what it changes");
}

}  // namespace

std::shared_ptr<const OtherPreset> take_snapshot(ViewsState& views, const Preset& preset) {
  const std::string name = fmt::format("snapshot {}", ++views.snapshots_taken);
  views.snapshots.push_back(std::make_shared<const OtherPreset>(OtherPreset{name, preset}));
  if (views.snapshots.size() > most_snapshots) views.snapshots.erase(views.snapshots.begin());
  return views.snapshots.back();
}

void take_other_preset(ViewsState& views, const std::string& file) {
  try {
    const auto other = std::make_shared<const OtherPreset>(OtherPreset{file_name(file), load_preset(file)});
    ViewContent& own = views.contents[std::size_t(views.preset_for.view)];
    if (!views.preset_for.is_compared) {
      own.other = other;
      return;
    }
    ViewContent with = compares_view(views, views.preset_for.view) ? views.comparison->with : own;
    with.other = other;
    choose_other(views, views.preset_for.view, with);
  } catch (const std::exception& error) {
    views.error = error.what();
  }
}

void choose_other(ViewsState& views, int index, const ViewContent& with, std::optional<int> follows) {
  Comparison comparison = views.comparison.value_or(Comparison{});
  comparison.view = index;
  comparison.with = with;
  comparison.follows = follows;
  views.comparison = comparison;
}

bool compares_view(const ViewsState& views, int index) {
  return views.comparison && views.comparison->view == index;
}

void comparison_menu(int index, StudioState& state, const StudioInputs& inputs, const Preset& preset) {
  ImGui::TextDisabled("Compare with");
  other_items(index, state, inputs, preset);
  if (!compares_view(state.views, index)) return;
  Comparison& comparison = *state.views.comparison;
  ImGui::Separator();
  const auto how = [&](const char* text, const char* name, ComparisonKind kind) {
    if (ImGui::RadioButton(text, comparison.kind == kind)) comparison.kind = kind;
    note_item(state.widgets, name);
  };
  how("Line to drag", "how/divider", ComparisonKind::divider);
  how("Difference", "how/difference", ComparisonKind::difference);
  how("Difference with its sign", "how/signed", ComparisonKind::signed_difference);
  how("One after the other", "how/blink", ComparisonKind::blink);
  if (comparison.takes_difference()) {
    field_label("amplified");
    double power = std::log2(comparison.amplification);
    ImGui::SetNextItemWidth(scaled(120));
    const double least = 0, most = 12;
    if (ImGui::SliderScalar("##amplification", ImGuiDataType_Double, &power, &least, &most,
                            fmt::format("{:g} times", comparison.amplification).c_str()))
      comparison.amplification = std::exp2(std::round(power));
    note_item(state.widgets, "##amplification");
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Stop comparing", key_text_of("Back").c_str())) state.views.comparison.reset();
  note_item(state.widgets, "stop comparing");
}

bool move_divider(ViewsState& views, bool is_hovered, bool is_active, ImVec2 low, ImVec2 size) {
  Comparison& comparison = *views.comparison;
  if (comparison.kind != ComparisonKind::divider) return false;
  const float mouse = ImGui::GetIO().MousePos.x, x = low.x + size.x * comparison.divider;
  const bool is_near = is_hovered && std::abs(mouse - x) <= scaled(divider_reach);
  if (is_near && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) views.moves_divider = true;
  if (!is_active) views.moves_divider = false;
  if (is_near || views.moves_divider) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (views.moves_divider) comparison.divider = std::clamp((mouse - low.x) / size.x, 0.0F, 1.0F);
  return views.moves_divider;
}

bool draw_comparison(StudioState& state, const StudioInputs& inputs, ImVec2 low, ImVec2 size) {
  const Comparison& comparison = *state.views.comparison;
  const std::uintptr_t own = inputs.views[std::size_t(comparison.view)].texture;
  const std::uintptr_t other = inputs.views[compared_picture].texture;
  if (own == 0 || other == 0) return false;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high{low.x + size.x, low.y + size.y};
  const std::string name = text_of(state.views.contents[std::size_t(comparison.view)]),
                    other_name = text_of(comparison.with);
  const ImVec2 top{low.x + scaled(10), low.y + scaled(8)};
  const bool shows_other = std::fmod(ImGui::GetTime(), 2 * blink_s) >= blink_s;
  switch (comparison.kind) {
    case ComparisonKind::divider:
      draw_divided(list, comparison, own, other, low, size);
      text_on_picture(list, top, name);
      text_on_picture(list, {high.x - ImGui::CalcTextSize(other_name.c_str()).x - scaled(10), top.y},
                      other_name);
      break;
    case ComparisonKind::difference:
    case ComparisonKind::signed_difference:
      draw_difference(list, state, inputs.difference, own, low, high);
      text_on_picture(list, top, fmt::format("{} less {}", other_name, name));
      break;
    case ComparisonKind::blink:
      list.AddImage(id_of(shows_other ? other : own), low, high);
      text_on_picture(list, top, shows_other ? other_name : name);
      break;
  }
  return true;
}

}  // namespace crest
