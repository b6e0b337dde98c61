#include "render/raycaster/features.h"

#include <fmt/format.h>

#include <algorithm>

#include "presets/names.h"
#include "render/volume/clip.h"

namespace crest {
namespace {

bool shows_anything(const TransferFunction& tf) {
  return std::ranges::any_of(tf.points, [](const ControlPoint& p) { return p.opacity > 0; });
}

bool takes_away(const std::optional<ClipBox>& clip, const Grid& grid) {
  const Box box = rendered_box(grid, clip);
  return box.min != grid.box_min() || box.max != grid.box_max();
}

}  // namespace

Features needed_features(const Volume& volume, const Classification& classification,
                         const Rendering& rendering, bool statistics) {
  const bool wants_peaks = rendering.mode != Mode::dvr_only;
  Features features;
  features.dvr = rendering.mode != Mode::peak_only && shows_anything(classification.tf);
  features.peaks = wants_peaks && !classification.surfaces.empty();
  features.split = features.peaks && features.dvr && rendering.peak_form == PeakForm::split;
  features.one_peak = features.peaks && classification.surfaces.size() == 1;
  features.extrema = features.peaks && rendering.peak_form == PeakForm::split;
  features.exclusive =
      features.peaks && rendering.mode == Mode::peak_xor_dvr && rendering.peak_form == PeakForm::paper;
  // The base TF holds also where no spike's value is in the field's range: its flanks may be.
  features.base_tf =
      rendering.mode == Mode::peak_xor_dvr && rendering.peak_form == PeakForm::split &&
      std::ranges::any_of(classification.peaks, [](const Peak& p) { return p.spike && p.shown; });
  if (features.dvr || features.peaks) features.placement = rendering.placement;
  features.clip_box = takes_away(rendering.clip_box, volume.grid);
  features.shading = rendering.shading == Shading::gradient;
  features.early_termination = rendering.early_termination > 0;
  features.empty_cells = volume.has_empty_cells();
  features.statistics = statistics;
  features.peak_table = features.peaks && classification.surfaces.size() > most_peaks_without_table;
  return features;
}

std::vector<std::string> shader_defines(const Features& f) {
  std::vector<std::string> defines;
  const auto add = [&](const char* name, int value) { defines.push_back(fmt::format("{} {}", name, value)); };
  add("DVR", f.dvr);
  add("PEAKS", f.peaks);
  add("PEAK_TABLE", f.peak_table);
  add("ONE_PEAK", f.one_peak);
  add("SPLIT", f.split);
  add("EXTREMA", f.extrema);
  add("EXCLUSIVE", f.exclusive);
  add("PLACEMENT_EYE", f.placement == Placement::eye);
  add("PLACEMENT_ENTRY", f.placement == Placement::entry);
  add("PLACEMENT_ENTRY_EXIT", f.placement == Placement::entry_exit);
  add("SHADING", f.shading);
  add("EARLY_TERMINATION", f.early_termination);
  add("EMPTY_CELLS", f.empty_cells);
  add("STATISTICS", f.statistics);
  return defines;
}

std::vector<std::string> feature_names(const Features& f) {
  std::vector<std::string> names;
  const auto add = [&](bool in, std::string_view name) {
    if (in) names.emplace_back(name);
  };
  add(f.dvr, "dvr");
  add(f.peaks, "peaks");
  add(f.peak_table, "peak_table");
  add(f.split, "split");
  add(f.extrema, "extrema");
  add(f.exclusive, "exclusive");
  add(f.base_tf, "base_tf");
  add(f.placement != Placement::entry_exit_corner, fmt::format("placement_{}", name_of(f.placement)));
  add(f.clip_box, "clip_box");
  add(f.shading, "shading");
  add(f.early_termination, "early_termination");
  add(f.empty_cells, "empty_cells");
  add(f.statistics, "statistics");
  return names;
}

std::vector<std::pair<std::string, std::string>> left_out(const Features& f, const Volume& volume,
                                                          const Classification& classification,
                                                          const Rendering& rendering) {
  std::vector<std::pair<std::string, std::string>> list;
  const auto add = [&](bool in, const char* name, std::string why) {
    if (!in) list.emplace_back(name, std::move(why));
  };
  const bool dvr_only = rendering.mode == Mode::dvr_only;
  const std::string no_peaks = dvr_only                       ? "the mode is DVR_ONLY"
                               : classification.peaks.empty() ? "the transfer function has no peak"
                               : !f.peaks                     ? "no surface lies in the volume's range"
                                                              : "";
  add(f.dvr, "dvr",
      rendering.mode == Mode::peak_only ? "the mode is PEAK_ONLY"
                                        : "no point of the transfer function has an opacity");
  add(f.peaks, "peaks", no_peaks);
  add(f.peak_table, "peak_table",
      f.peaks
          ? fmt::format("few enough surfaces ({}) to be tested all at once", classification.surfaces.size())
          : no_peaks);
  add(f.split, "split",
      !f.peaks ? no_peaks
      : !f.dvr ? "there is no DVR to be divided"
               : "the peak form is the paper's");
  add(f.extrema, "extrema", !f.peaks ? no_peaks : "the peak form is the paper's");
  add(f.base_tf, "base_tf", "no spike is taken out of the DVR in this mode and form");
  add(f.placement != Placement::entry_exit_corner, "placement",
      rendering.placement == Placement::entry_exit_corner
          ? "entry_exit_corner, the default, is the plain shader"
          : "nothing is sampled");
  add(f.clip_box, "clip_box",
      rendering.clip_box ? "the whole volume lies in it" : "rendering.clip_box is not set");
  add(f.shading, "shading", "rendering.shading is none");
  add(f.early_termination, "early_termination", "rendering.early_termination is 0");
  add(f.empty_cells, "empty_cells", fmt::format("all {} voxels have a value", volume.grid.point_count()));
  add(f.statistics, "statistics", "nobody asked for counts");
  return list;
}

}  // namespace crest
