#include "ui/setting_text.h"

#include <fmt/core.h>

#include "ui/mode_text.h"

namespace crest {

ValueText text_of(Mode mode) { return {title_of(mode), explanation_of(mode)}; }

ValueText text_of(Engine engine) {
  switch (engine) {
    case Engine::raycaster:
      return {"Ray caster", "A ray a pixel; draws every mode"};
    case Engine::vdls:
      return {"View-dependent layers",
              "Layer after layer of all rays; draws the volume, the ray caster the rest"};
    case Engine::reference:
      break;
  }
  return {"Reference", "The exact answer, from crest render and compare; here the ray caster draws"};
}

ValueText text_of(Placement placement) {
  switch (placement) {
    case Placement::eye:
      return {"From the eye", "Whole steps from the eye; the last one sticks out"};
    case Placement::entry:
      return {"From the entry", "Whole steps from where the ray enters; the last one sticks out"};
    case Placement::entry_exit:
      return {"Entry to exit", "Equal steps; none in a corner that is shorter than a step"};
    case Placement::entry_exit_corner:
      break;
  }
  return {"Entry to exit, corners too", "Equal steps, at least one"};
}

ValueText text_of(Sampling sampling) {
  switch (sampling) {
    case Sampling::uniform:
      return {"Even", "All steps are of the length above"};
    case Sampling::differential:
      return {"Growing with distance", "Steps grow with the distance from the eye (Knoll et al. 2009)"};
    case Sampling::footprint:
      break;
  }
  return {"By what a pixel covers", "Steps in proportion to what a pixel covers"};
}

ValueText text_of(ClassificationMethod method) {
  switch (method) {
    case ClassificationMethod::post:
      return {"Sample by sample", "The curve at each sample's value"};
    case ClassificationMethod::preintegrated:
      return {"Pre-integrated", "The curve over all values between a step's ends, in closed form"};
    case ClassificationMethod::preintegrated_table:
      return {"Pre-integrated, by table",
              "The same from a table for one step length: even steps from the entry"};
    case ClassificationMethod::analytic:
      break;
  }
  return {"Exact, without steps",
          "From cell to cell, of trilinear fields; step and placement have no part in it"};
}

ValueText text_of(PeakForm form) {
  if (form == PeakForm::split) return {"Divided at its crossings", "Second order"};
  return {"As published", "First order"};
}

ValueText text_of(Filter filter) {
  switch (filter) {
    case Filter::linear:
      return {"Trilinear", "By the texture unit, whose weights may have 8 bits"};
    case Filter::linear_exact:
      return {"Trilinear, in float", "The same from 8 reads, without the texture unit's rounding"};
    case Filter::bspline:
      return {"Cubic B-spline", "Smooth, from 8 fetches"};
    case Filter::bc:
      break;
  }
  return {"Cubic, with B and C", "Of the family of Mitchell and Netravali, from 64 reads"};
}

ValueText text_of(Shading shading) {
  if (shading == Shading::none) return {"None", "Colours as the curve has them"};
  return {"Lit from the eye", "By the gradient, with a light at the eye"};
}

ValueText text_of(Gradient gradient) {
  if (gradient == Gradient::central) return {"Central differences", "Over a voxel to either side"};
  return {"Of the filter", "The filter's own derivative"};
}

ValueText text_of(BlendMode mode) {
  switch (mode) {
    case BlendMode::semi_transparent:
      return {"Semi-transparent", "The integral of the curve along the ray"};
    case BlendMode::lookup:
      return {"Opacity as it is", "A sample's opacity counts whatever the step; no peaks are shown"};
    case BlendMode::iso_surface:
      return {"Isosurface", "White and opaque at half the greatest opacity; no peaks are shown"};
    case BlendMode::maximum:
      return {"Maximum", "The greatest value along the ray, as a grey; no peaks are shown"};
    case BlendMode::minimum:
      return {"Minimum", "The least value along the ray, as a grey; no peaks are shown"};
    case BlendMode::mean:
      break;
  }
  return {"Mean", "The mean of the values along the ray, as a grey; no peaks are shown"};
}

bool titled_choice(WidgetState& state, const char* name, int& value, std::span<const TitledChoice> choices,
                   float width) {
  const std::size_t now = std::size_t(value);
  const auto explain = [](const TitledChoice& choice) {
    tip(fmt::format("{}\n{} in files and on the command line", choice.meaning, choice.name).c_str());
  };
  ImGui::SetNextItemWidth(width);
  const bool open =
      ImGui::BeginCombo(name, std::string(choices[now].title).c_str(), ImGuiComboFlags_HeightLarge);
  note_item(state, name);
  if (!open) {
    explain(choices[now]);
    return false;
  }
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (ImGui::Selectable(std::string(choices[i].title).c_str(), i == now)) value = int(i);
    note_item(state, fmt::format("{}/{}", name, choices[i].name));
    explain(choices[i]);
  }
  ImGui::EndCombo();
  return std::size_t(value) != now;
}

}  // namespace crest
