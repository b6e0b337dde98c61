#include "render/raycaster/scene_facts.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "render/classify/peak_table.h"
#include "render/scene/view.h"
#include "render/shader_inputs/blend_mode.h"
#include "render/volume/largest_change.h"
#include "render/volume/macrocells.h"

namespace crest {

int SceneFacts::cells_on_axes() const { return grid.dims.x + grid.dims.y + grid.dims.z; }

int SceneFacts::spans(const Features& features) const {
  const int cells = cells_on_axes();
  return 1 + (features.empty_cells ? cells : 0) +
         (features.adaptive ? cells / macrocell_side(grid, statistics) + 3 : 0);
}

int SceneFacts::walk_rounds(const Features& features) const {
  const int cells = cells_on_axes();
  const int macrocells =
      features.adaptive || features.skipping ? 4 * (cells / macrocell_side(grid, statistics) + 3) : 0;
  return (features.empty_cells ? 2 * cells : 0) + macrocells;
}

std::string SceneFacts::why_nothing() const {
  if (box.is_empty()) return "the clip box leaves nothing of the volume";
  return may_see(camera, aspect(), box) ? "" : "the camera does not see the volume";
}

// The base TF holds also where no spike's own value is in the field's range: its flanks may be.
std::string SceneFacts::why_no_base_tf() const {
  if (!is_semi_transparent()) return blend_mode();
  if (!is_exclusive(rendering.mode)) return "the mode is not PEAK_XOR_DVR";
  if (!is_divided()) return "the peak form is the paper's";
  const auto& points = classification.tf.points;
  const auto is_met = [&](const Peak& p) {
    return p.spike && p.shown && points[p.left].value <= dvr_field().max &&
           points[p.right].value >= dvr_field().min;
  };
  return std::ranges::any_of(classification.peaks, is_met) ? ""
                                                           : "no spike in the volume's range is a surface";
}

std::string SceneFacts::why_no_dvr() const {
  if (!shows_dvr(rendering.mode)) return mode();
  if (shows_values(rendering.blend_mode)) return "";
  if (largest_opacity(dvr_tf(), dvr_field()) > 0) return "";
  if (largest_opacity(classification.tf, dvr_field()) > 0)
    return "without its spikes, which are surfaces, the transfer function shows nothing";
  return "the transfer function shows nothing in the volume's range";
}

std::string SceneFacts::why_no_analytic() const {
  if (!is_analytic(rendering.classification))
    return fmt::format("rendering.classification is {}", name_of(rendering.classification));
  return is_semi_transparent() || !shows_dvr(rendering.mode) ? "" : blend_mode();
}

std::string SceneFacts::why_no_peaks() const {
  if (!shows_surfaces(rendering.mode)) return mode();
  if (shows_dvr(rendering.mode) && !is_semi_transparent()) return blend_mode();
  if (!surfaces().empty()) return "";
  if (classification.peaks.empty()) return "the transfer function has no peak";
  const bool shown = std::ranges::any_of(classification.peaks, &Peak::shown);
  return shown ? "no surface lies in the volume's range" : "no peak is shown as a surface";
}

std::string SceneFacts::why_no_several_peaks(int peak_bins) const {
  if (surfaces().size() == 1) return "there is one surface";
  const double reach =
      largest_change(grid, statistics, root_filter(rendering), steps.longest * grid.smallest_spacing());
  const double gap = smallest_gap(surfaces());
  const double bin = peak_bins > 0 ? surface_field().width() / peak_bins * (1 + 1e-3) : 0;
  if (!(reach + 2 * bin < gap)) return "";
  return fmt::format("values change by {:.3g} at most in a step, and surfaces are {:.3g} apart", reach, gap);
}

std::string SceneFacts::why_no_preintegration() const {
  if (!is_semi_transparent()) return blend_mode();
  if (is_preintegrated(rendering.classification)) return why_no_dvr();
  return fmt::format("rendering.classification is {}", name_of(rendering.classification));
}

std::string SceneFacts::why_no_preintegration_table() const {
  if (const std::string none = why_no_preintegration(); !none.empty()) return none;
  return holds_one_length(rendering.classification) ? "" : "antiderivatives hold for every length";
}

std::string SceneFacts::why_no_own_root_filter(const Features& features) const {
  const FieldFilter dvr = dvr_filter(rendering), root = root_filter(rendering);
  if (dvr == root) return fmt::format("surfaces lie in the field of the samples: {}", name_of(root.kind));
  if (!features.peaks) return why_no_peaks();
  return features.dvr ? "" : why_no_dvr();
}

std::string SceneFacts::why_no_filter_gradient(const Features& features) const {
  if (!features.shading) return "there is no shading";
  switch (rendering.gradient) {
    case Gradient::filter:
      return "";
    case Gradient::central:
      break;
  }
  return fmt::format("rendering.gradient is {}", name_of(rendering.gradient));
}

std::string SceneFacts::why_no_clip_box() const {
  if (!rendering.clip_box) return "rendering.clip_box is not set";
  const bool takes_away = box.min != grid.box_min() || box.max != grid.box_max();
  return takes_away ? "" : "the whole volume lies in it";
}

// Not even a ray that is as long as any, through the densest material, with as many crossings of the most
// opaque surface as its steps can hold, becomes that dark.
std::string SceneFacts::why_no_early_termination(const Features& features) const {
  if (!(rendering.early_termination > 0)) return "rendering.early_termination is 0";
  double depth = 0;
  if (features.dvr)
    depth += extinction(largest_opacity(dvr_tf(), dvr_field()), classification.tf.unit_distance) *
             (longest_ray + steps.longest) * grid.smallest_spacing();
  if (features.peaks) {
    const double opacity = std::ranges::max(surfaces(), {}, &Peak::opacity).opacity;
    const double count = double(surfaces().size());
    const double most = features.analytic ? 3 * count * cells_on_axes()
                                          : (is_divided() ? 2 * count : rendering.max_peaks) *
                                                (steps.most + 2 * spans(features));
    depth -= std::log1p(-opacity) * most;
  }
  const double least = std::exp(-depth);
  if (!(least * (1 - 1e-3) > rendering.early_termination)) return "";
  return fmt::format("no ray can lose more than {:.3g} of its light", 1 - least);
}

std::string SceneFacts::why_no_empty_cells() const {
  if (statistics.empty_max.x < statistics.empty_min.x)
    return fmt::format("all {} voxels have a value", grid.point_count());
  const double around = support_radius(rendering) - 1;  // the statistics' cells are those of radius 1
  const glm::dvec3 first = glm::max(glm::dvec3(statistics.empty_min) - around, glm::dvec3(0));
  const glm::dvec3 last = glm::min(glm::dvec3(statistics.empty_max) + around, glm::dvec3(grid.dims - 1));
  const Box empty{grid.origin + grid.spacing * first, grid.origin + grid.spacing * last};
  // Rays are cast in float32: a thousandth of a cell beside it counts as in it
  const glm::dvec3 margin = 1e-3 * grid.spacing;
  const Box met{glm::max(empty.min - margin, box.min), glm::min(empty.max + margin, box.max)};
  if (met.is_empty()) return "the clip box leaves no cell without a value";
  return may_see(camera, aspect(), met) ? "" : "no cell without a value is in view";
}

std::string SceneFacts::why_no_long_rays(const Need& need) const {
  if (need.intervals > need.intervals_per_pass) return "";
  return fmt::format("{} intervals of the longest ray are few enough for one pass", need.intervals);
}

}  // namespace crest
