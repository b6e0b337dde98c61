#include "ui/rendering_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "presets/choices.h"
#include "ui/choice_rows.h"
#include "ui/feature_list.h"
#include "ui/number_field.h"
#include "ui/setting_text.h"
#include "ui/style.h"

namespace crest {
namespace {

constexpr FieldRule step_rule{.min = 1e-3, .max = 1e3}, cubic{.min = -10, .max = 10};

/// What is drawn while it lives is not for now: it keeps its place, greyed.
struct Disabled {
  explicit Disabled(bool disabled) { ImGui::BeginDisabled(disabled); }
  ~Disabled() { ImGui::EndDisabled(); }
  Disabled(const Disabled&) = delete;
  Disabled& operator=(const Disabled&) = delete;
};

/// A row of the form: what it is, and under the mouse what it means.
void row(const char* text, const char* meaning) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", text);
  tip(meaning);
  ImGui::TableNextColumn();
}

/// One axis of the clip box, in a row at least `width` wide. Its planes keep a thousandth of the volume
/// between them.
bool clip_axis(WidgetState& widgets, ClipBox& clip, int axis, ValueRange side, float width) {
  static constexpr std::array names{"##clip min x", "##clip min y", "##clip min z",
                                    "##clip max x", "##clip max y", "##clip max z"};
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float half = (std::clamp(ImGui::GetContentRegionAvail().x, width, 2 * width) - gap) / 2;
  const double least = side.width() / 1000;
  double& low = clip.min[axis];
  double& high = clip.max[axis];
  bool changed = false;
  if (slider(widgets, names[std::size_t(axis)], low, side, half)) {
    low = std::min(low, side.max - least);
    high = std::max(high, low + least);
    changed = true;
  }
  ImGui::SameLine(0, gap);
  if (slider(widgets, names[std::size_t(axis) + 3], high, side, half)) {
    high = std::max(high, side.min + least);
    low = std::min(low, high - least);
    changed = true;
  }
  return changed;
}

/// Whether there is a clip box, and its planes in the volume's box.
bool clip_rows(WidgetState& widgets, std::optional<ClipBox>& clip, const Volume* volume, float width) {
  bool changed = false;
  row("Clip", "Only what lies in this box is rendered: from and to on each axis, in world units");
  bool clipped = clip.has_value();
  {
    const Disabled while_empty(!volume && !clipped);
    changed = checkbox(widgets, "##clip box", clipped);
  }
  if (changed) clip.reset();
  if (changed && clipped) clip = ClipBox{volume->grid.box_min(), volume->grid.box_max(), ""};
  ClipBox shown = clip.value_or(volume ? ClipBox{volume->grid.box_min(), volume->grid.box_max(), ""}
                                       : ClipBox{glm::dvec3(0), glm::dvec3(1), ""});
  const Disabled without(!clip);
  for (int axis = 0; axis < 3; ++axis) {
    static constexpr const char* labels[] = {"    x", "    y", "    z"};
    row(labels[axis], "Where the clip box begins and ends; Ctrl+click types a number");
    const ValueRange side = volume ? ValueRange{volume->grid.box_min()[axis], volume->grid.box_max()[axis]}
                                   : ValueRange{shown.min[axis], shown.max[axis]};
    if (clip_axis(widgets, shown, axis, side, width) && clip) {
      clip = shown;
      changed = true;
    }
  }
  return changed;
}

/// Settings that do not go together give way to the one that was just chosen. Whether they did.
bool reconcile(Rendering& r, bool classification_was_chosen) {
  if (why_inconsistent(r).empty()) return false;
  if (is_analytic(r.classification)) {
    if (classification_was_chosen) {
      r = with_trilinear_filters(r);
    } else {
      r.classification = ClassificationMethod::post;
    }
    return true;
  }
  if (classification_was_chosen) {
    r.placement = Placement::entry;
    r.sampling = Sampling::uniform;
    r.adaptive = false;
  } else {
    r.classification = ClassificationMethod::preintegrated;
  }
  return true;
}

/// A root filter of its own is the entry after "same".
bool root_filter_choice(WidgetState& widgets, std::optional<Filter>& filter, float width) {
  constexpr std::size_t count = std::size(EnumNames<Filter>::table);
  std::array<TitledChoice, count + 1> choices{{{"As above", "same", "One field for surfaces and samples"}}};
  int index = 0;
  for (std::size_t i = 0; i < count; ++i) {
    choices[i + 1] = titled(EnumNames<Filter>::table[i].value);
    if (filter == EnumNames<Filter>::table[i].value) index = int(i) + 1;
  }
  if (!titled_choice(widgets, "##root filter", index, choices, width)) return false;
  filter.reset();
  if (index > 0) filter = EnumNames<Filter>::table[std::size_t(index) - 1].value;
  return true;
}

/// B and C, which one filter has.
bool bc_row(WidgetState& widgets, Rendering& r, float width) {
  row("    B and C",
      "Of the family of Mitchell and Netravali:\n"
      "1, 0 - the cubic B-spline, which smooths\n"
      "0, 0.5 - Catmull-Rom: through the grid's points, and beyond their values\n"
      "1/3, 1/3 - a compromise\n"
      "2, 1 - what Knoll et al. 2009 call the B-spline is not monotone:\n"
      "it makes surfaces that are not in the data. Theirs is 1, 0.");
  const Disabled without(r.filter != Filter::bc && r.root_filter != Filter::bc);
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x, half = (width - gap) / 2;
  bool changed = number_field(widgets, "##bc b", r.bc_b, cubic, half);
  ImGui::SameLine(0, gap);
  changed |= number_field(widgets, "##bc c", r.bc_c, cubic, half);
  return changed;
}

bool quality_rows(WidgetState& widgets, Rendering& r, float field, bool& classified) {
  row("Method", "How a step's colour and opacity follow from the field");
  classified = titled_choice(widgets, "##classification", r.classification, field);
  row("Step", "Length of a ray's steps, in the smallest spacing of the volume; of even sampling");
  bool changed = number_field(widgets, "##step", r.step, step_rule, field);
  row("Filter", "How the field is made between the grid's points");
  changed |= titled_choice(widgets, "##filter", r.filter, field);
  changed |= bc_row(widgets, r, field);
  return changed;
}

bool look_rows(WidgetState& widgets, Rendering& r, float field) {
  row("Shading", "Whether surfaces and samples are lit");
  bool changed = titled_choice(widgets, "##shading", r.shading, field);
  row("    Gradient", "Where the light's normals come from");
  {
    const Disabled without(!takes_gradient(r.shading));
    changed |= titled_choice(widgets, "##gradient", r.gradient, field);
  }
  row("Blend mode", "What a sample contributes to its ray; all but the first show no peaks");
  changed |= titled_choice(widgets, "##illumination", r.blend_mode, field);
  row("Background", "Behind the volume");
  changed |= color_square(widgets, "##background", r.background);
  return changed;
}

bool sampling_rows(WidgetState& widgets, Rendering& r, float field) {
  row("Placement", "Where a ray's samples lie");
  bool changed = titled_choice(widgets, "##placement", r.placement, field);
  row("Step lengths", "How long the steps are from place to place");
  changed |= titled_choice(widgets, "##sampling", r.sampling, field);
  row("    Pixels a step", "s_k: the step at the eye, in pixels' diagonals at distance 1");
  {
    const Disabled without(has_equal_steps(r.sampling));
    changed |= number_field(widgets, "##s_k", r.s_k, step_rule, field);
  }
  row("Adaptive", "Joins up to 8 steps to one where the field is smooth");
  changed |= checkbox(widgets, "##adaptive", r.adaptive);
  row("Skip empty space", "Takes no samples where nothing shows; the picture stays the same");
  changed |= checkbox(widgets, "##skipping", r.skipping);
  row("Early termination", "Residual transmittance at which a ray stops; 0 = never");
  changed |= number_field(widgets, "##early termination", r.early_termination, unit_interval, field);
  return changed;
}

bool peak_rows(WidgetState& widgets, Rendering& r, float field) {
  row("Steps with peaks", "How a step with crossings is integrated");
  bool changed = titled_choice(widgets, "##peak form", r.peak_form, field);
  row("Filter of surfaces",
      "That of the field in which surfaces lie; with another one than above a step takes two samples");
  changed |= root_filter_choice(widgets, r.root_filter, field);
  row("Most peaks a step",
      "Crossings that one step composites at most as published; divided, it composites all");
  changed |= integer_field(widgets, "##max peaks", r.max_peaks, 1, 64, field);
  row("Table bins, peaks", "Bins of the peak table on each axis");
  changed |= integer_field(widgets, "##peak bins", r.peak_bins, 1, 4096, field);
  row("Table bins, volume", "Bins of the pre-integration table on each axis");
  const Disabled without(!holds_one_length(r.classification));
  changed |= integer_field(widgets, "##preintegration bins", r.preintegration_bins, 2, 2048, field);
  return changed;
}

bool engine_rows(WidgetState& widgets, Rendering& r, float field) {
  row("Engine", "What draws the views");
  bool changed = titled_choice(widgets, "##engine", r.engine, field);
  {
    const Disabled without(r.engine != Engine::vdls);
    row("    Layers a pass", "Samples that a pass takes of each ray; the paper's graphics card: 2");
    changed |= integer_field(widgets, "##layers per pass", r.vdls.layers_per_pass, 1, 64, field);
    row("    Early test", "Rays that are out of the volume are left alone");
    changed |= checkbox(widgets, "##early test", r.vdls.early_test);
  }
  row("Mode in the file", "The mode that the preset is rendered in elsewhere; the views show all four");
  changed |= titled_choice(widgets, "##mode", r.mode, field);
  return changed;
}

/// A part of the form that opens and closes; `rows` draws what is in it and returns whether it changed.
template <class Rows>
bool group(WidgetState& widgets, const char* name, bool open_at_first, Rows&& rows) {
  ImGui::PushFont(font_of(TextSize::heading));
  const bool open = ImGui::CollapsingHeader(name, open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  ImGui::PopFont();
  note_item(widgets, fmt::format("group/{}", name));
  if (!open || !ImGui::BeginTable(fmt::format("{} rows", name).c_str(), 2, ImGuiTableFlags_SizingStretchProp))
    return false;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, scaled(140));
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
  const bool changed = rows();
  ImGui::EndTable();
  return changed;
}

}  // namespace

bool rendering_panel(Document& document, StudioState& state, const StudioInputs& inputs,
                     StudioRequests& requests) {
  Rendering& r = document.preset.rendering;
  WidgetState& widgets = state.widgets;
  const float field = scaled(220);
  bool classified = false;
  bool changed = group(widgets, "Quality", true, [&] { return quality_rows(widgets, r, field, classified); });
  changed |= group(widgets, "Look", true, [&] { return look_rows(widgets, r, field); });
  changed |=
      group(widgets, "Clip", true, [&] { return clip_rows(widgets, r.clip_box, inputs.volume, field); });
  changed |= group(widgets, "Advanced", false, [&] {
    bool any = engine_rows(widgets, r, field);
    any |= sampling_rows(widgets, r, field);
    any |= peak_rows(widgets, r, field);
    return any;
  });
  // What comes and goes lies below all that is clicked
  choice_rows(document, state, inputs, requests);
  feature_list(state, inputs, r.mode);
  return reconcile(r, classified) || classified || changed;
}

}  // namespace crest
