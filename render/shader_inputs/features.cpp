#include "render/shader_inputs/features.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

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
      {&Features::own_root_filter, "own_root_filter", "OWN_ROOT_FILTER"},
      {&Features::analytic, "analytic", nullptr},  // a shader of its own
      {&Features::preintegrated, "preintegrated", "PREINTEGRATED"},
      {&Features::preintegration_table, "preintegration_table", "PREINTEGRATION_TABLE"},
      {&Features::clip_box, "clip_box", nullptr},
      {&Features::shading, "shading", "SHADING"},
      {&Features::filter_gradient, "filter_gradient", "FILTER_GRADIENT"},
      {&Features::early_termination, "early_termination", "EARLY_TERMINATION"},
      {&Features::differential, "differential", "DIFFERENTIAL"},
      {&Features::footprint, "footprint", "FOOTPRINT"},
      {&Features::adaptive, "adaptive", "ADAPTIVE"},
      {&Features::skipping, "skipping", "SKIPPING"},
      {&Features::empty_cells, "empty_cells", "EMPTY_CELLS"},
      {&Features::whole_values, "whole_values", "WHOLE_VALUES"},
      {&Features::bricks, "bricks", "BRICKS"},
      {&Features::long_rays, "long_rays", "LONG_RAYS"},
      {&Features::statistics, "statistics", "STATISTICS"},
  };
  return features;
}

namespace {

/// The texture unit gives no derivative: that of the trilinear field takes its texels.
Filter gradient_filter(Filter filter) { return filter == Filter::linear ? Filter::linear_exact : filter; }

std::string define_of(std::string_view prefix, std::string_view name, bool in) {
  std::string define = fmt::format("{}_{} {:d}", prefix, name, in);
  std::ranges::transform(define, define.begin(), [](char c) { return char(std::toupper(c)); });
  return define;
}

void add_filter_defines(std::vector<std::string>& defines, const Features& features) {
  const auto add_function = [&](const char* name, Filter filter, const char* of) {
    defines.push_back(fmt::format("{} {}_{}", name, name_of(filter), of));
  };
  for (const auto& [filter, name] : names_of<Filter>()) {
    defines.push_back(define_of("FILTER", name, uses_filter(features, filter)));
  }
  add_function("ROOT_FIELD", features.root_filter, "field");
  add_function("DVR_FIELD", features.filter, "field");
  if (!features.filter_gradient) return;
  add_function("ROOT_GRADIENT", gradient_filter(features.root_filter), "gradient");
  add_function("DVR_GRADIENT", gradient_filter(features.filter), "gradient");
}

}  // namespace

bool uses_filter(const Features& features, Filter filter) {
  const auto uses = [&](Filter used) {
    return filter == used || (features.filter_gradient && filter == gradient_filter(used));
  };
  return uses(features.filter) || uses(features.root_filter);
}

std::vector<std::string> shader_defines(const Features& features) {
  std::vector<std::string> defines;
  const auto add = [&](const char* name, bool in) { defines.push_back(fmt::format("{} {:d}", name, in)); };
  for (const FeatureName& feature : all_features())
    if (feature.define) add(feature.define, features.*feature.in);
  for (const auto& [placement, name] : names_of<Placement>())
    defines.push_back(define_of("PLACEMENT", name, features.placement == placement));
  add_filter_defines(defines, features);
  for (const auto& [blend_mode, name] : names_of<BlendMode>())
    defines.push_back(define_of("BLEND", name, features.blend_mode == blend_mode));
  return defines;
}

std::vector<std::string> feature_names(const Features& features) {
  std::vector<std::string> names;
  for (const FeatureName& feature : all_features())
    if (features.*feature.in) names.emplace_back(feature.name);
  if (features.placement != Placement::entry_exit_corner)
    names.push_back(fmt::format("placement_{}", name_of(features.placement)));
  if (features.filter != Filter::linear) names.push_back(fmt::format("filter_{}", name_of(features.filter)));
  if (features.own_root_filter) names.push_back(fmt::format("root_filter_{}", name_of(features.root_filter)));
  if (features.blend_mode != BlendMode::semi_transparent)
    names.push_back(fmt::format("illumination_{}", name_of(features.blend_mode)));
  return names;
}

}  // namespace crest
