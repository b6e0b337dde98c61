#include "ui/rendering_panel.h"

namespace crest {
namespace {

constexpr double least_step = 1e-3, largest_step = 1e3;

/// A row of the form: what it is, and under the mouse what it means.
void row(const char* text, const char* meaning) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", text);
  tip(meaning);
  ImGui::TableNextColumn();
}

}  // namespace

bool rendering_panel(Document& document, StudioState& state) {
  Rendering& r = document.preset.rendering;
  WidgetState& widgets = state.widgets;
  if (!ImGui::BeginTable("rendering", 2, ImGuiTableFlags_SizingStretchProp)) return false;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, scaled(140));
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
  const float field = scaled(180);
  bool changed = false;
  row("Step", "Length of a ray's steps, in the smallest spacing of the volume");
  changed |= number_field(widgets, "##step", r.step, {least_step, largest_step}, field);
  row("Peak form",
      "How a step with crossings is integrated:\nsplit - divided at its crossings (second order)\npaper - as "
      "published (first order)");
  changed |= choice(widgets, "##peak form", r.peak_form, field);
  row("Most peaks a step", "Crossings that one step composites at most");
  changed |= integer_field(widgets, "##max peaks", r.max_peaks, 1, 64, field);
  row("Table bins", "Bins of the peak table on each axis");
  changed |= integer_field(widgets, "##peak bins", r.peak_bins, 1, 4096, field);
  row("Shading", "none, or by the gradient with a light at the eye");
  changed |= choice(widgets, "##shading", r.shading, field);
  row("Early termination", "Residual transmittance at which a ray stops; 0 = never");
  changed |= number_field(widgets, "##early termination", r.early_termination, {0, 1}, field);
  row("Background", "Behind the volume");
  changed |= color_square(widgets, "##background", r.background);
  row("Mode in the file", "The mode that the preset is rendered in elsewhere; the views show all four");
  changed |= choice(widgets, "##mode", r.mode, field);
  ImGui::EndTable();
  return changed;
}

}  // namespace crest
