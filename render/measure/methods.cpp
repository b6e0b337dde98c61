#include "render/measure/methods.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/choices.h"
#include "presets/preset_file.h"
#include "render/classify/classification.h"
#include "render/vdls/vdls.h"

namespace crest {
namespace {

constexpr Method table[] = {
    {"dvr", "DVR, equal steps, rounded up", "mode=DVR_ONLY",
     "Steps over what is thinner than a step: thin peaks are lost, steps of the TF land up to half a step "
     "off; its table of the TF blurs what is narrower than an entry at any step."},
    {"dvr-entry-exit", "DVR, equal steps, rounded down", "mode=DVR_ONLY placement=entry_exit",
     "As dvr; takes no sample of a ray that is shorter than a step, so corners are lost."},
    {"dvr-entry", "DVR, steps counted from the entry", "mode=DVR_ONLY placement=entry",
     "As dvr; its last step sticks out of the volume or ends before its border, by up to half a step."},
    {"dvr-eye", "DVR, steps counted from the eye", "mode=DVR_ONLY placement=eye",
     "As dvr; its first and last step stick out of the volume or end before its border."},
    {"dvr-pre", "DVR, pre-integrated", "mode=DVR_ONLY classification=preintegrated",
     "Takes the field for linear within a step: loses what is entered and left again in one, and mixes a "
     "step's colours."},
    {"dvr-pre-table", "DVR, pre-integrated, table of two values",
     "mode=DVR_ONLY classification=preintegrated_table placement=entry",
     "As dvr-pre; blurs what is narrower than a bin of its table, and gets worse again at small steps."},
    {"dvr-analytic", "DVR, cell by cell", "mode=DVR_ONLY classification=analytic",
     "Draws the trilinear field alone, not that of a cubic filter; takes longer a frame than samples half a "
     "voxel apart.",
     false},
    {"dvr-linear-exact", "DVR, trilinear in float", "mode=DVR_ONLY filter=linear_exact",
     "As dvr; a sample costs 8 reads."},
    {"dvr-bspline", "DVR, cubic B-spline", "mode=DVR_ONLY filter=bspline",
     "As dvr; blurs the data, and does not pass through its values."},
    {"dvr-bc", "DVR, cubic filter of Mitchell and Netravali", "mode=DVR_ONLY filter=bc",
     "As dvr; its field may go beyond the data's values, and a sample costs 64 reads."},
    {"dvr-differential", "DVR, steps as published (s_k = 8 step)", "mode=DVR_ONLY sampling=differential",
     "As dvr, with longer steps far from the eye, so that more is lost there.", true, 8},
    {"dvr-footprint", "DVR, steps by footprint (s_k = 8 step)", "mode=DVR_ONLY sampling=footprint",
     "As dvr, with longer steps far from the eye, so that more is lost there.", true, 8},
    {"dvr-adaptive", "DVR, steps joined where smooth", "mode=DVR_ONLY adaptive=true",
     "As dvr, with up to eight steps joined where the field is smooth, where thin peaks are lost sooner."},
    {"dvr-vdls", "DVR, view-dependent layer sampling", "mode=DVR_ONLY engine=vdls",
     "As dvr; shows no surfaces, and takes neither other filters nor other steps than dvr's."},
    {"peaks", "Peaks alone, divided steps", "mode=PEAK_ONLY peak_form=split",
     "Shows no volume; misses surfaces entered and left within a step where the samples around it do not "
     "foretell it: silhouettes, parts thinner than a step, labels."},
    {"peaks-paper", "Peaks alone, as published", "mode=PEAK_ONLY peak_form=paper",
     "Shows no volume; misses every surface entered and left within a step, and composites max_peaks "
     "crossings of a step at most."},
    {"peaks-analytic", "Peaks alone, cell by cell", "mode=PEAK_ONLY classification=analytic",
     "Shows no volume; draws the trilinear field alone, not that of a cubic filter; where a ray all but "
     "touches a surface it rounds as 32-bit float does.",
     false},
    {"xor", "Peaks and base TF, divided steps", "mode=PEAK_XOR_DVR peak_form=split",
     "Misses surfaces as peaks does; steps of the TF between them land up to half a step off, as with dvr."},
    {"xor-paper", "Peaks or samples, as published", "mode=PEAK_XOR_DVR peak_form=paper",
     "Misses surfaces as peaks-paper does; a step that crosses one shows no volume, which leaves rings that "
     "shrink with the step."},
    {"xor-pre", "Peaks and base TF, divided steps, pre-integrated",
     "mode=PEAK_XOR_DVR peak_form=split classification=preintegrated",
     "Misses surfaces as peaks does; takes the field for linear between them, and mixes a part's colours."},
    {"xor-pre-table", "Peaks and base TF, divided steps, table of two values",
     "mode=PEAK_XOR_DVR peak_form=split classification=preintegrated_table placement=entry",
     "As xor-pre; blurs what is narrower than a bin of its table."},
    {"xor-analytic", "Peaks and base TF, cell by cell", "mode=PEAK_XOR_DVR classification=analytic",
     "Draws the trilinear field alone, not that of a cubic filter; where a ray all but touches a surface it "
     "rounds as 32-bit float does.",
     false},
    {"xor-linear-exact", "Peaks and base TF, trilinear in float",
     "mode=PEAK_XOR_DVR peak_form=split filter=linear_exact root_filter=linear_exact", "As xor."},
    {"xor-bspline", "Peaks and base TF, cubic B-spline",
     "mode=PEAK_XOR_DVR peak_form=split filter=bspline root_filter=bspline",
     "As xor; blurs the data, and does not pass through its values."},
    {"xor-bc", "Peaks and base TF, cubic filter of Mitchell and Netravali",
     "mode=PEAK_XOR_DVR peak_form=split filter=bc root_filter=bc",
     "As xor; its field may go beyond the data's values, and a sample costs 64 reads."},
    {"xor-root-bspline", "Peaks of a cubic B-spline, base TF trilinear",
     "mode=PEAK_XOR_DVR peak_form=split filter=linear root_filter=bspline",
     "As xor; surfaces and volume are of two fields, which need not agree where they lie."},
    {"xor-differential", "Peaks and base TF, steps as published (s_k = 8 step)",
     "mode=PEAK_XOR_DVR sampling=differential",
     "As xor, with longer steps far from the eye, so that more is lost there.", true, 8},
    {"xor-footprint", "Peaks and base TF, steps by footprint (s_k = 8 step)",
     "mode=PEAK_XOR_DVR sampling=footprint",
     "As xor, with longer steps far from the eye, so that more is lost there.", true, 8},
    {"xor-adaptive", "Peaks and base TF, steps joined where smooth", "mode=PEAK_XOR_DVR adaptive=true",
     "As xor, with up to eight steps joined where the field is smooth, where surfaces are missed sooner."},
    {"both", "Peaks and DVR, divided steps", "mode=both peak_form=split",
     "Misses surfaces as peaks does; samples of the whole TF meet a spike's body now and then, which adds "
     "grains to its surface."},
    {"both-pre", "Peaks and DVR, divided steps, pre-integrated",
     "mode=both peak_form=split classification=preintegrated",
     "Misses surfaces as peaks does; counts a spike's body beside its surface, and mixes a part's colours."},
    {"both-analytic", "Peaks and DVR, cell by cell", "mode=both classification=analytic",
     "Counts a spike's body beside its surface; draws the trilinear field alone, not that of a cubic filter.",
     false},
    {"both-paper", "Peaks and DVR, as published", "mode=both peak_form=paper",
     "Misses surfaces as peaks-paper does; samples of the whole TF meet a spike's body now and then."},
};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return words;
}

/// How a method renders a scene, with the filters written out: those that it does not use are the others.
Rendering in_full(const Method& method, const Rendering& scene) {
  Rendering r = measured_rendering(method, scene.step, scene);
  if (!shows_surfaces(r.mode)) r.root_filter = r.filter;
  r.root_filter = root_filter(r).kind;
  if (!shows_dvr(r.mode)) r.filter = *r.root_filter;
  return r;
}

/// A method before this one in the table that renders the scene in the same way: where the scene has the
/// filters that this one sets.
const Method* find_twin(const Method& method, const Rendering& scene) {
  for (const Method& other : table) {
    if (other.id == method.id) return nullptr;
    if (in_full(other, scene) == in_full(method, scene)) return &other;
  }
  return nullptr;
}

}  // namespace

std::span<const Method> methods() { return table; }

const Method* find_method(std::string_view id) {
  const auto found = std::ranges::find(table, id, &Method::id);
  return found == std::end(table) ? nullptr : &*found;
}

Rendering measured_rendering(const Method& method, double step, const Rendering& scene) {
  Preset preset;
  preset.rendering.clip_box = scene.clip_box;
  preset.rendering.background = scene.background;
  preset.rendering = with_filters_of(preset.rendering, scene);
  preset.rendering.vdls = scene.vdls;
  preset.rendering.bc_b = scene.bc_b;
  preset.rendering.bc_c = scene.bc_c;
  preset.rendering.max_peaks = scene.max_peaks;
  preset.rendering.peak_bins = scene.peak_bins;
  preset.rendering.preintegration_bins = scene.preintegration_bins;
  preset.transfer_function = default_transfer_function();  // a preset has one
  for (const std::string_view word : words_of(method.settings))
    preset = set_field(preset, fmt::format("rendering.{}", word));
  if (is_analytic(preset.rendering.classification))
    preset.rendering = with_trilinear_filters(preset.rendering);
  if (method.s_k_per_step > 0)
    preset.rendering.s_k = step * method.s_k_per_step;
  else if (method.has_step)
    preset.rendering.step = step;
  return preset.rendering;
}

Rendering with_filters_of(Rendering rendering, const Rendering& other) {
  rendering.filter = other.filter;
  rendering.root_filter = other.root_filter;
  return rendering;
}

Rendering with_method(const Rendering& scene, const Method& method, double step) {
  Rendering rendering = measured_rendering(method, step, scene);
  rendering.shading = scene.shading;
  rendering.gradient = scene.gradient;
  rendering.early_termination = scene.early_termination;
  rendering.unknown = scene.unknown;
  if (!method.has_step || method.s_k_per_step > 0) rendering.step = scene.step;
  if (method.s_k_per_step == 0) rendering.s_k = scene.s_k;
  return rendering;
}

std::vector<ExactAnswer> exact_answers_of(const Method& method, const Rendering& scene) {
  return exact_answers_of(measured_rendering(method, scene.step, scene));
}

std::string why_left_out(const Method& method, const Scene& scene) {
  Scene measured = scene;
  measured.rendering = measured_rendering(method, scene.rendering.step, scene.rendering);
  const Mode mode = measured.rendering.mode;
  if (const Method* twin = find_twin(method, scene.rendering))
    return fmt::format("with this scene's filters it is {}", twin->id);
  const bool is_clear = std::ranges::none_of(scene.tf.points, [](const auto& p) { return p.opacity > 0; });
  if (!shows_surfaces(mode) && is_clear) return "no point of the transfer function has an opacity";
  if (measured.rendering.engine == Engine::vdls) return why_not_vdls(measured);
  if (!shows_surfaces(mode)) return "";
  const auto classification = classify(scene.tf, surface_range(scene));
  return classification.surfaces.empty() ? "no surface lies in the volume's range" : "";
}

}  // namespace crest
