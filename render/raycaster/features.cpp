#include "render/raycaster/features.h"

#include <fmt/format.h>

#include "presets/names.h"

namespace crest {

const std::vector<FeatureName>& all_features() {
  static const std::vector<FeatureName> features{
      {&Features::dvr, "dvr", "DVR"},
      {&Features::peaks, "peaks", "PEAKS"},
      {&Features::peak_list, "peak_list", "PEAK_LIST"},
      {&Features::peak_table, "peak_table", "PEAK_TABLE"},
      {&Features::several_peaks, "several_peaks", "SEVERAL_PEAKS"},
      {&Features::split, "split", "SPLIT"},
      {&Features::extrema, "extrema", "EXTREMA"},
      {&Features::exclusive, "exclusive", "EXCLUSIVE"},
      {&Features::base_tf, "base_tf", nullptr},
      {&Features::preintegrated, "preintegrated", "PREINTEGRATED"},
      {&Features::preintegration_table, "preintegration_table", "PREINTEGRATION_TABLE"},
      {&Features::clip_box, "clip_box", nullptr},
      {&Features::shading, "shading", "SHADING"},
      {&Features::early_termination, "early_termination", "EARLY_TERMINATION"},
      {&Features::differential, "differential", "DIFFERENTIAL"},
      {&Features::footprint, "footprint", "FOOTPRINT"},
      {&Features::adaptive, "adaptive", "ADAPTIVE"},
      {&Features::skipping, "skipping", "SKIPPING"},
      {&Features::empty_cells, "empty_cells", "EMPTY_CELLS"},
      {&Features::long_rays, "long_rays", "LONG_RAYS"},
      {&Features::statistics, "statistics", "STATISTICS"},
  };
  return features;
}

std::vector<std::string> shader_defines(const Features& features) {
  std::vector<std::string> defines;
  const auto add = [&](const char* name, bool in) { defines.push_back(fmt::format("{} {:d}", name, in)); };
  for (const FeatureName& feature : all_features())
    if (feature.define) add(feature.define, features.*feature.in);
  add("PLACEMENT_EYE", features.placement == Placement::eye);
  add("PLACEMENT_ENTRY", features.placement == Placement::entry);
  add("PLACEMENT_ENTRY_EXIT", features.placement == Placement::entry_exit);
  return defines;
}

std::vector<std::string> feature_names(const Features& features) {
  std::vector<std::string> names;
  for (const FeatureName& feature : all_features())
    if (features.*feature.in) names.emplace_back(feature.name);
  if (features.placement != Placement::entry_exit_corner)
    names.push_back(fmt::format("placement_{}", name_of(features.placement)));
  return names;
}

}  // namespace crest
