#pragma once

#include <fmt/core.h>

#include <string>

#include "presets/choices.h"
#include "presets/names.h"
#include "render/raycaster/need.h"
#include "render/raycaster/step_lengths.h"
#include "render/volume/filter_bounds.h"

namespace crest {

/// What find_need knows of a scene and its picture: what it was asked for, and what follows from that at
/// once. Each function `why_no_...` tells why the scene does not need a feature, and returns "" where it
/// does.
struct SceneFacts {
  const Grid& grid;
  const VolumeStatistics& statistics;
  bool has_whole_values;  ///< volume/whole_values.h
  bool is_in_bricks;      ///< on the device (resources/volume_texture.h)
  const Classification& classification;
  const Rendering& rendering;
  const Camera& camera;
  glm::ivec2 size;     ///< of the picture
  Box box;             ///< what is rendered, in world units
  double longest_ray;  ///< in it, in smallest spacings
  StepLengths steps;   ///< on its rays, where they are sampled

  /// What the field can be where DVR samples it, and where surfaces lie.
  ValueRange dvr_field() const { return field_range(dvr_filter(rendering), statistics.range); }
  ValueRange surface_field() const { return field_range(root_filter(rendering), statistics.range); }
  const std::vector<Peak>& surfaces() const { return classification.surfaces; }
  bool is_semi_transparent() const { return rendering.blend_mode == BlendMode::semi_transparent; }
  std::string blend_mode() const {
    return fmt::format("rendering.illumination is {}", name_of(rendering.blend_mode));
  }
  std::string mode() const { return fmt::format("the mode is {}", name_of(rendering.mode)); }
  bool is_divided() const { return crest::is_divided(rendering); }

  std::string why_nothing() const;
  std::string why_no_analytic() const;
  std::string why_no_base_tf() const;
  std::string why_no_dvr() const;
  std::string why_no_peaks() const;
  std::string why_no_several_peaks(int peak_bins) const;
  std::string why_no_preintegration() const;
  std::string why_no_preintegration_table() const;
  std::string why_no_own_root_filter(const Features& features) const;
  std::string why_no_filter_gradient(const Features& features) const;
  std::string why_no_clip_box() const;
  std::string why_no_early_termination(const Features& features) const;
  std::string why_no_empty_cells() const;
  std::string why_no_long_rays(const Need& need) const;

  /// What DVR shows in this mode.
  const TransferFunction& dvr_tf() const {
    return why_no_base_tf().empty() ? classification.base : classification.tf;
  }
  double aspect() const { return double(size.x) / size.y; }
  /// No ray meets more cells.
  int cells_on_axes() const;
  /// The most spans of a ray that are marched on their own: each may take two intervals more.
  int spans(const Features& features) const;
  /// The most rounds of the loops that walk along a ray from cell to cell.
  int walk_rounds(const Features& features) const;
};

}  // namespace crest
