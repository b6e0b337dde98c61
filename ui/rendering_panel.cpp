#include "ui/rendering_panel.h"

#include <algorithm>
#include <array>

#include "presets/choices.h"
#include "ui/choice_rows.h"
#include "ui/feature_list.h"
#include "ui/number_field.h"

namespace crest {
namespace {

constexpr FieldRule step_rule{.min = 1e-3, .max = 1e3}, cubic{.min = -10, .max = 10};

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
  row("Clip box", "Only what lies in this box is rendered: from and to on each axis, in world units");
  bool clipped = clip.has_value();
  if (volume || clipped) {
    changed = checkbox(widgets, "##clip box", clipped);
  } else {
    ImGui::TextDisabled("no volume");
  }
  if (changed) clip.reset();
  if (changed && clipped) clip = ClipBox{volume->grid.box_min(), volume->grid.box_max(), ""};
  if (!clip) return changed;
  for (int axis = 0; axis < 3; ++axis) {
    static constexpr const char* labels[] = {"    x", "    y", "    z"};
    row(labels[axis], "Where the clip box begins and ends; Ctrl+click types a number");
    const ValueRange side = volume ? ValueRange{volume->grid.box_min()[axis], volume->grid.box_max()[axis]}
                                   : ValueRange{clip->min[axis], clip->max[axis]};
    changed |= clip_axis(widgets, *clip, axis, side, width);
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
  std::array<std::string_view, count + 1> names{"same"};
  int index = 0;
  for (std::size_t i = 0; i < count; ++i) {
    names[i + 1] = EnumNames<Filter>::table[i].name;
    if (filter == EnumNames<Filter>::table[i].value) index = int(i) + 1;
  }
  if (!choice(widgets, "##root filter", index, names, width)) return false;
  filter.reset();
  if (index > 0) filter = EnumNames<Filter>::table[std::size_t(index) - 1].value;
  return true;
}

/// How the field is reconstructed; B and C where a filter has them.
bool filter_rows(WidgetState& widgets, Rendering& r, float width) {
  static constexpr const char* family =
      "Of the family of Mitchell and Netravali:\n"
      "1, 0 - the cubic B-spline, which smooths\n"
      "0, 0.5 - Catmull-Rom: through the grid's points, and beyond their values\n"
      "1/3, 1/3 - a compromise\n"
      "2, 1 - what Knoll et al. 2009 call the B-spline is not monotone:\n"
      "it makes surfaces that are not in the data. Theirs is 1, 0.";
  row("Filter",
      "How the field is made between the grid's points:\n"
      "linear - by the texture unit, whose weights may have 8 bits\n"
      "linear_exact - the same in float, from 8 reads\n"
      "bspline - the cubic B-spline, smooth, from 8 fetches\n"
      "bc - any of the family with B and C, from 64 reads");
  bool changed = choice(widgets, "##filter", r.filter, width);
  row("Root filter",
      "That of the field in which surfaces lie; with another one than above a step takes two samples");
  changed |= root_filter_choice(widgets, r.root_filter, width);
  if (r.filter == Filter::bc || r.root_filter == Filter::bc) {
    row("    B", family);
    changed |= number_field(widgets, "##bc b", r.bc_b, cubic, width);
    row("    C", family);
    changed |= number_field(widgets, "##bc c", r.bc_c, cubic, width);
  }
  return changed;
}

bool engine_rows(WidgetState& widgets, Rendering& r, float width) {
  row("Engine",
      "raycaster\nvdls - view-dependent layer sampling: draws the DVR_ONLY view, and the ray caster the "
      "others\nreference - the exact answer (crest render and compare); the views are drawn by the ray "
      "caster");
  bool changed = choice(widgets, "##engine", r.engine, width);
  if (r.engine == Engine::vdls) {
    row("    Layers a pass", "Samples that a pass takes of each ray; the paper's graphics card: 2");
    changed |= integer_field(widgets, "##layers per pass", r.vdls.layers_per_pass, 1, 64, width);
    row("    Early test", "Rays that are out of the volume are left alone");
    changed |= checkbox(widgets, "##early test", r.vdls.early_test);
  }
  return changed;
}

}  // namespace

bool rendering_panel(Document& document, StudioState& state, const StudioInputs& inputs,
                     StudioRequests& requests) {
  choice_rows(document, state, inputs, requests);
  Rendering& r = document.preset.rendering;
  WidgetState& widgets = state.widgets;
  if (!ImGui::BeginTable("rendering", 2, ImGuiTableFlags_SizingStretchProp)) return false;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, scaled(140));
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
  const float field = scaled(180);
  bool changed = engine_rows(widgets, r, field);
  row("Step", "Length of a ray's steps, in the smallest spacing of the volume; of uniform sampling");
  changed |= number_field(widgets, "##step", r.step, step_rule, field);
  row("Placement",
      "Where a ray's samples lie:\nentry_exit_corner - midpoints of equal segments, at least one\nentry_exit "
      "- the "
      "same, but none in a corner shorter than a step\nentry, eye - whole steps from the entry or the eye; "
      "the last "
      "one falls short or sticks out");
  changed |= choice(widgets, "##placement", r.placement, field);
  row("Sampling",
      "How long a ray's steps are:\nuniform - all of the length above\ndifferential - growing with the "
      "distance from "
      "the eye (Knoll et al. 2009)\nfootprint - in proportion to what a pixel covers");
  changed |= choice(widgets, "##sampling", r.sampling, field);
  if (!has_equal_steps(r.sampling)) {
    row("Pixels a step", "s_k: the step at the eye, in pixels' diagonals at distance 1");
    changed |= number_field(widgets, "##s_k", r.s_k, step_rule, field);
  }
  row("Adaptive", "Joins up to 8 steps to one where the field is smooth");
  changed |= checkbox(widgets, "##adaptive", r.adaptive);
  row("Skip empty space", "Takes no samples where nothing shows; the picture stays the same");
  changed |= checkbox(widgets, "##skipping", r.skipping);
  row("Classification",
      "How a step's colour and opacity follow from the field:\npost - the TF at a sample\npreintegrated - "
      "the TF's "
      "antiderivatives between the values at the step's ends\npreintegrated_table - a table of both values; "
      "it holds "
      "one step length, so it takes uniform sampling from the entry\nanalytic - no steps: exact from cell to "
      "cell, of trilinear fields; step, placement, sampling, adaptive, peak form and the peak table have no "
      "part in it");
  const bool classified = choice(widgets, "##classification", r.classification, field);
  if (holds_one_length(r.classification)) {
    row("Table bins, DVR", "Bins of the pre-integration table on each axis");
    changed |= integer_field(widgets, "##preintegration bins", r.preintegration_bins, 2, 2048, field);
  }
  row("Peak form",
      "How a step with crossings is integrated:\nsplit - divided at its crossings (second order)\npaper - as "
      "published (first order)");
  changed |= choice(widgets, "##peak form", r.peak_form, field);
  changed |= filter_rows(widgets, r, field);
  row("Most peaks a step",
      "Crossings that one step composites at most in the paper's form; the split form composites all");
  changed |= integer_field(widgets, "##max peaks", r.max_peaks, 1, 64, field);
  row("Table bins, peaks", "Bins of the peak table on each axis");
  changed |= integer_field(widgets, "##peak bins", r.peak_bins, 1, 4096, field);
  row("Shading", "none, or by the gradient with a light at the eye");
  changed |= choice(widgets, "##shading", r.shading, field);
  if (takes_gradient(r.shading)) {
    row("Gradient",
        "central - differences of the filtered field over a voxel to either side\nfilter - the filter's own "
        "derivative");
    changed |= choice(widgets, "##gradient", r.gradient, field);
  }
  row("Blend mode",
      "What a sample contributes to its ray:\nsemi_transparent - the integral of the transfer "
      "function\nlookup - "
      "its opacity as it is, whatever the step\niso_surface - white and opaque where the transfer function "
      "has half "
      "its greatest opacity\nmaximum, minimum, mean - of the values, as a grey\nAll but the first show no "
      "peaks");
  changed |= choice(widgets, "##illumination", r.blend_mode, field);
  row("Early termination", "Residual transmittance at which a ray stops; 0 = never");
  changed |= number_field(widgets, "##early termination", r.early_termination, unit_interval, field);
  changed |= clip_rows(widgets, r.clip_box, inputs.volume, field);
  row("Background", "Behind the volume");
  changed |= color_square(widgets, "##background", r.background);
  row("Mode in the file", "The mode that the preset is rendered in elsewhere; the views show all four");
  changed |= choice(widgets, "##mode", r.mode, field);
  ImGui::EndTable();
  feature_list(state, inputs, r.mode);
  return reconcile(r, classified) || classified || changed;
}

}  // namespace crest
