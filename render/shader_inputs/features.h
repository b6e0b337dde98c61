#pragma once

#include <string>
#include <vector>

#include "presets/preset.h"

namespace crest {

/// What a picture needs of the ray caster; everything else is compiled out of its shader.
struct Features {
  bool dvr = false;              ///< DVR samples
  bool peaks = false;            ///< crossings of surfaces; of a single one, unless one of these is there:
  bool peak_list = false;        ///< up to most_listed_peaks, tested all at once
  bool peak_table = false;       ///< candidates from the table
  bool several_peaks = false;    ///< more than one surface within reach of a step: they are met in order
  bool split = false;            ///< segments divided at their crossings
  bool extrema = false;          ///< surfaces entered and left within one step are looked for, too
  bool exclusive = false;        ///< in the paper's form: no DVR sample in a step with a crossing
  bool base_tf = false;          ///< DVR takes the TF without its spikes
  bool own_root_filter = false;  ///< surfaces lie in another filter's field than DVR samples
  bool analytic = false;         ///< rays are solved from cell to cell, without samples
  bool preintegrated = false;    ///< DVR by segments between field values, not by samples
  bool preintegration_table = false;  ///< of both values, for one length; else by antiderivatives
  bool clip_box = false;              ///< which takes something away from the volume
  bool shading = false;
  bool filter_gradient = false;  ///< by the filter's derivative, not by central differences
  bool early_termination = false;
  bool differential = false;  ///< steps that grow with the distance from the eye, as published
  bool footprint = false;     ///< or in proportion to it
  bool adaptive = false;      ///< steps are joined where the field is smooth
  bool skipping = false;      ///< of macrocells in which nothing shows
  bool empty_cells = false;   ///< voxels without a value are in view
  bool whole_values = false;  ///< the volume's values are whole numbers of steps, in 16 bits
  bool bricks = false;        ///< only those parts of the volume are held that may show
  bool long_rays = false;     ///< drawn in several passes
  bool statistics = false;
  Placement placement = Placement::entry_exit_corner;
  BlendMode blend_mode = BlendMode::semi_transparent;
  Filter filter = Filter::linear;       ///< of DVR samples, and without them of surfaces
  Filter root_filter = Filter::linear;  ///< of surfaces, and without them of DVR samples

  bool operator==(const Features&) const = default;
};

/// So many surfaces are tested all at once, which takes less time than a look into the table.
inline constexpr int most_listed_peaks = 4;

/// A feature that is there or not: its name for people, and the shader's define, or null where the shader is
/// the same with it and without.
struct FeatureName {
  bool Features::*in;
  const char *name, *define;
};
/// All of them, in the order in which they are listed.
const std::vector<FeatureName>& all_features();

/// Whether a field's value or gradient comes from such a filter.
bool uses_filter(const Features& features, Filter filter);

/// The ray caster's shader for them.
inline const char* fragment_shader(const Features& features) {
  return features.analytic ? "analytic.frag" : "raycaster.frag";
}

/// The shader's defines, as "NAME value"; the same features give the same list.
std::vector<std::string> shader_defines(const Features& features);

/// The names of what is in, for people.
std::vector<std::string> feature_names(const Features& features);

}  // namespace crest
