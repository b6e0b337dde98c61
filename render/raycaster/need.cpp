#include "render/raycaster/need.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "presets/error.h"
#include "presets/names.h"
#include "render/classify/antiderivatives.h"
#include "render/classify/peak_table.h"
#include "render/raycaster/largest_change.h"
#include "render/raycaster/step_lengths.h"
#include "render/view.h"
#include "render/volume/filter_bounds.h"
#include "render/volume/macrocells.h"

namespace crest {
namespace {

/// Some drivers (Mesa's llvmpipe) end all loops of one invocation together after 65,535 rounds, in silence.
constexpr int most_loop_rounds = 60000;

/// What find_need is asked, with what follows from it at once. Each of its functions tells why a feature is
/// not needed, or nothing where it is.
struct Scenery {
  const Grid& grid;
  const VolumeStatistics& statistics;
  const Classification& classification;
  const Rendering& rendering;
  const Camera& camera;
  glm::ivec2 size;     ///< of the picture
  Box box;             ///< what is rendered, in world units
  double longest_ray;  ///< in it, in smallest spacings
  StepLengths steps;   ///< on its rays

  /// What the field can be where DVR samples it, and where surfaces lie.
  ValueRange dvr_field() const { return field_range(dvr_filter(rendering), statistics.range); }
  ValueRange surface_field() const { return field_range(root_filter(rendering), statistics.range); }
  const std::vector<Peak>& surfaces() const { return classification.surfaces; }
  bool is_split() const { return rendering.peak_form == PeakForm::split; }

  std::string why_nothing() const;
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
  int spans(const Features& features) const;
  int walk_rounds(const Features& features) const;
};

/// Stretches of a ray that are marched on their own, at most: each may take two intervals more.
int Scenery::spans(const Features& features) const {
  const int cells = grid.dims.x + grid.dims.y + grid.dims.z;
  return 1 + (features.empty_cells ? cells : 0) + (features.adaptive ? cells / macrocell_side(grid) + 3 : 0);
}

/// Rounds of the loops that walk along a ray.
int Scenery::walk_rounds(const Features& features) const {
  const int cells = grid.dims.x + grid.dims.y + grid.dims.z;
  const int macrocells = features.adaptive || features.skipping ? 4 * (cells / macrocell_side(grid) + 3) : 0;
  return (features.empty_cells ? 2 * cells : 0) + macrocells;
}

std::string Scenery::why_nothing() const {
  if (box.is_empty()) return "the clip box leaves nothing of the volume";
  return may_see(camera, aspect(), box) ? "" : "the camera does not see the volume";
}

// The base TF holds also where no spike's own value is in the field's range: its flanks may be.
std::string Scenery::why_no_base_tf() const {
  if (rendering.mode != Mode::peak_xor_dvr) return "the mode is not PEAK_XOR_DVR";
  if (!is_split()) return "the peak form is the paper's";
  const auto& points = classification.tf.points;
  const auto is_met = [&](const Peak& p) {
    return p.spike && p.shown && points[p.left].value <= dvr_field().max &&
           points[p.right].value >= dvr_field().min;
  };
  return std::ranges::any_of(classification.peaks, is_met) ? ""
                                                           : "no spike in the volume's range is a surface";
}

std::string Scenery::why_no_dvr() const {
  if (rendering.mode == Mode::peak_only) return "the mode is PEAK_ONLY";
  if (largest_opacity(dvr_tf(), dvr_field()) > 0) return "";
  if (largest_opacity(classification.tf, dvr_field()) > 0)
    return "without its spikes, which are surfaces, the transfer function shows nothing";
  return "the transfer function shows nothing in the volume's range";
}

std::string Scenery::why_no_peaks() const {
  if (rendering.mode == Mode::dvr_only) return "the mode is DVR_ONLY";
  if (!surfaces().empty()) return "";
  if (classification.peaks.empty()) return "the transfer function has no peak";
  const bool shown = std::ranges::any_of(classification.peaks, &Peak::shown);
  return shown ? "no surface lies in the volume's range" : "no peak is shown as a surface";
}

std::string Scenery::why_no_several_peaks(int peak_bins) const {
  if (surfaces().size() == 1) return "there is one surface";
  const double reach =
      largest_change(grid, statistics, root_filter(rendering), steps.longest * grid.smallest_spacing());
  const double gap = smallest_gap(surfaces());
  const double bin = peak_bins > 0 ? surface_field().width() / peak_bins * (1 + 1e-3) : 0;
  if (!(reach + 2 * bin < gap)) return "";
  return fmt::format("values change by {:.3g} at most in a step, and surfaces are {:.3g} apart", reach, gap);
}

std::string Scenery::why_no_preintegration() const {
  return rendering.classification == ClassificationMethod::post ? "rendering.classification is post"
                                                                : why_no_dvr();
}

std::string Scenery::why_no_preintegration_table() const {
  if (const std::string none = why_no_preintegration(); !none.empty()) return none;
  return rendering.classification == ClassificationMethod::preintegrated_table
             ? ""
             : "antiderivatives hold for every length";
}

std::string Scenery::why_no_own_root_filter(const Features& features) const {
  const FieldFilter dvr = dvr_filter(rendering), root = root_filter(rendering);
  if (dvr == root) return fmt::format("surfaces lie in the field of the samples: {}", name_of(root.kind));
  if (!features.peaks) return why_no_peaks();
  return features.dvr ? "" : why_no_dvr();
}

std::string Scenery::why_no_filter_gradient(const Features& features) const {
  if (!features.shading) return "there is no shading";
  return rendering.gradient == Gradient::filter ? "" : "rendering.gradient is central";
}

std::string Scenery::why_no_clip_box() const {
  if (!rendering.clip_box) return "rendering.clip_box is not set";
  const bool takes_away = box.min != grid.box_min() || box.max != grid.box_max();
  return takes_away ? "" : "the whole volume lies in it";
}

// Not even a ray that is as long as any, through the densest material, with as many crossings of the most
// opaque surface as its steps can hold, becomes that dark.
std::string Scenery::why_no_early_termination(const Features& features) const {
  if (!(rendering.early_termination > 0)) return "rendering.early_termination is 0";
  double depth = 0;
  if (features.dvr)
    depth += extinction(largest_opacity(dvr_tf(), dvr_field()), classification.tf.unit_distance) *
             (longest_ray + steps.longest) * grid.smallest_spacing();
  if (features.peaks) {
    const double opacity = std::ranges::max(surfaces(), {}, &Peak::opacity).opacity;
    const double most = is_split() ? 2 * int(surfaces().size()) : rendering.max_peaks;
    depth -= std::log1p(-opacity) * most * (steps.most + 2 * spans(features));
  }
  const double least = std::exp(-depth);
  if (!(least * (1 - 1e-3) > rendering.early_termination)) return "";
  return fmt::format("no ray can lose more than {:.3g} of its light", 1 - least);
}

std::string Scenery::why_no_empty_cells() const {
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

std::string Scenery::why_no_long_rays(const Need& need) const {
  if (need.intervals > need.intervals_per_pass) return "";
  return fmt::format("{} intervals of the longest ray are few enough for one pass", need.intervals);
}

int intervals_of(const Scenery& s, const Features& features) {
  return int(std::min(s.steps.most + 2.0 * s.spans(features), 2e9));
}

int intervals_per_pass(const Scenery& s, const Features& features) {
  const int candidates = features.peak_table      ? std::max(int(s.surfaces().size()), 1)
                         : features.several_peaks ? most_listed_peaks
                                                  : 1;
  // A step may be two parts; a crossing in one takes a round, and two for its root
  const int rounds = features.peaks ? 4 + 6 * candidates : 1;
  return std::max(1, (most_loop_rounds - s.walk_rounds(features)) / rounds);
}

/// Takes the features one after the other: each may depend on those before it.
class Decision {
 public:
  Decision(const Scenery& scenery, const Forced& forced, const OccupiedShare& occupied_share)
      : s_(scenery), forced_(forced), occupied_share_(occupied_share) {}
  Need make(bool statistics);

 private:
  /// The feature is in unless there is a reason against it; also if it is forced in, where that is
  /// `harmless`.
  void decide(bool Features::*feature, std::string why_not, bool harmless = true) {
    need_.needed.*feature = why_not.empty();
    need_.features.*feature = why_not.empty() || (harmless && forced_.features.*feature);
    reasons_.emplace_back(feature, std::move(why_not));
  }
  void decide_peaks();
  void decide_forms();
  void decide_tf_table();
  void decide_filters();
  void decide_steps();
  std::string why_no_skipping() const;
  void decide_rays(bool statistics);
  void write_list();

  const Scenery& s_;
  const Forced& forced_;
  const OccupiedShare& occupied_share_;
  Need need_;
  std::vector<std::pair<bool Features::*, std::string>> reasons_;
};

void Decision::decide_peaks() {
  const Features& f = need_.features;
  const std::string none = s_.why_no_peaks();
  const auto unless_none = [&](std::string why_not) { return none.empty() ? std::move(why_not) : none; };
  const std::size_t count = s_.surfaces().size();
  const bool needs_table = count > most_listed_peaks;
  const std::string single = count == 1 ? "there is one surface" : "";
  const std::string few = fmt::format("{} surfaces can be tested all at once", count);
  decide(&Features::peaks, none);
  decide(&Features::peak_table, unless_none(needs_table ? "" : single.empty() ? few : single), f.peaks);
  decide(&Features::peak_list, unless_none(f.peak_table ? "the peak table has them" : single),
         f.peaks && !f.peak_table);
  if (f.peak_table) {
    const int most = s_.rendering.peak_bins;
    need_.peak_bins = forced_.large_tables ? most : separating_bins(s_.surfaces(), s_.surface_field(), most);
  }
  decide(&Features::several_peaks, unless_none(s_.why_no_several_peaks(need_.peak_bins)), f.peaks);
}

// The peak form decides what becomes of peaks and DVR, also where one of them was forced in.
void Decision::decide_forms() {
  const Features& f = need_.features;
  const std::string paper = s_.is_split() ? "" : "the peak form is the paper's";
  const std::string none = f.peaks ? "" : s_.why_no_peaks();
  const std::string nothing_to_divide = !none.empty() ? none
                                        : f.dvr       ? ""
                                                      : "there is no DVR beside the peaks";
  decide(&Features::extrema, none.empty() ? paper : none, false);
  decide(&Features::split, nothing_to_divide.empty() ? paper : nothing_to_divide, false);
  decide(&Features::exclusive,
         !nothing_to_divide.empty()                ? nothing_to_divide
         : s_.rendering.mode != Mode::peak_xor_dvr ? "the mode is not PEAK_XOR_DVR"
         : s_.is_split()                           ? "the peak form is split"
                                                   : "",
         false);
}

void Decision::decide_tf_table() {
  decide(&Features::base_tf, need_.needed.dvr ? s_.why_no_base_tf() : s_.why_no_dvr(), false);
  const double spacing = s_.grid.smallest_spacing();
  if (need_.needed.dvr)
    need_.tf_table =
        tf_table_size(s_.dvr_tf(), s_.dvr_field(), spacing, glm::length(s_.grid.box_size()) / spacing);
  if (forced_.large_tables) need_.tf_table.entries = largest_tf_table;
  decide(&Features::preintegrated, s_.why_no_preintegration(), false);
  decide(&Features::preintegration_table, s_.why_no_preintegration_table(), false);
  if (need_.features.preintegration_table)
    need_.preintegration_bins =
        is_constant(s_.dvr_tf(), s_.dvr_field()) ? 2 : s_.rendering.preintegration_bins;
  const int entries =
      need_.features.preintegration_table ? need_.preintegration_bins : need_.tf_table.entries;
  if (need_.needed.dvr) need_.tf_blur = s_.dvr_field().width() / (entries - 1);
}

// Without this much that is empty the walk through the macrocells takes longer than it saves
// (bench_features).
constexpr double most_occupied = 0.8;

std::string Decision::why_no_skipping() const {
  if (!s_.rendering.skipping) return "rendering.skipping is false";
  if (!occupied_share_) return "no macrocells are known";
  const double share = occupied_share_(need_.needed, need_.tf_blur);
  return share <= most_occupied ? ""
                                : fmt::format("{:.0f} % of the macrocells may show something", 100 * share);
}

void Decision::decide_steps() {
  const Sampling sampling = s_.rendering.sampling;
  const std::string name = fmt::format("rendering.sampling is {}", name_of(sampling));
  decide(&Features::differential, sampling == Sampling::differential ? "" : name, false);
  decide(&Features::footprint, sampling == Sampling::footprint ? "" : name, false);
  decide(&Features::adaptive, s_.rendering.adaptive ? "" : "rendering.adaptive is false", false);
  decide(&Features::skipping, why_no_skipping());
  if (sampling == Sampling::uniform)
    need_.features.placement = need_.needed.placement = s_.rendering.placement;
}

// One filter, unless both DVR and surfaces are there with different ones.
void Decision::decide_filters() {
  Features& f = need_.features;
  decide(&Features::own_root_filter, s_.why_no_own_root_filter(f), false);
  f.filter = dvr_filter(s_.rendering).kind;
  f.root_filter = root_filter(s_.rendering).kind;
  if (!f.own_root_filter) (f.dvr ? f.root_filter : f.filter) = f.dvr ? f.filter : f.root_filter;
  need_.needed.filter = f.filter;
  need_.needed.root_filter = f.root_filter;
}

void Decision::decide_rays(bool statistics) {
  const bool samples = need_.features.dvr || need_.features.peaks;
  const auto if_sampled = [&](std::string why_not) {
    return samples ? std::move(why_not) : "nothing is sampled";
  };
  if (samples)
    decide_steps();
  else
    for (const auto feature :
         {&Features::differential, &Features::footprint, &Features::adaptive, &Features::skipping})
      decide(feature, "nothing is sampled", false);
  decide(&Features::clip_box, s_.why_no_clip_box(), false);
  decide(&Features::shading,
         if_sampled(s_.rendering.shading == Shading::gradient ? "" : "rendering.shading is none"));
  decide(&Features::filter_gradient, if_sampled(s_.why_no_filter_gradient(need_.features)),
         need_.features.shading && !need_.needed.shading);
  decide(&Features::empty_cells, if_sampled(s_.why_no_empty_cells()));
  decide(&Features::early_termination, if_sampled(s_.why_no_early_termination(need_.needed)));
  need_.intervals = intervals_of(s_, need_.features);
  need_.intervals_per_pass = intervals_per_pass(s_, need_.features);
  if (forced_.intervals_per_pass > 0)
    need_.intervals_per_pass = std::min(need_.intervals_per_pass, forced_.intervals_per_pass);
  decide(&Features::long_rays, if_sampled(s_.why_no_long_rays(need_)));
  decide(&Features::statistics, statistics ? "" : "nobody asked for counts");
}

void Decision::write_list() {
  FeatureList& list = need_.list;
  list.in = feature_names(need_.features);
  for (const FeatureName& feature : all_features())
    for (const auto& [in, why_not] : reasons_)
      if (in == feature.in && !(need_.features.*in)) list.left_out.emplace_back(feature.name, why_not);
  if (need_.features.placement == Placement::entry_exit_corner)
    list.left_out.emplace_back("placement",
                               s_.rendering.sampling != Sampling::uniform
                                   ? fmt::format("rendering.sampling is {}", name_of(s_.rendering.sampling))
                               : s_.rendering.placement == Placement::entry_exit_corner
                                   ? "entry_exit_corner, the default, is the plain shader"
                                   : "nothing is sampled");
  if (need_.features.filter == Filter::linear)
    list.left_out.emplace_back("filter", "linear, the default, is the texture unit's");
  if (const auto& part = need_.tf_table.blurred)
    list.notes.push_back(
        fmt::format("the transfer function {} at {:.6g}, {} than an entry of the largest table: DVR shows it "
                    "blurred, {}",
                    part->width() > 0 ? "has a feature" : "has a step", part->min,
                    part->width() > 0 ? fmt::format("{:.3g} wide, narrower", part->width()) : "narrower",
                    need_.features.preintegrated ? "with all of its depth" : "or not at all"));
}

Need Decision::make(bool statistics) {
  const std::string nothing = s_.why_nothing();
  need_.visible = nothing.empty();
  if (need_.visible) {
    decide(&Features::dvr, s_.why_no_dvr());
    decide_peaks();
    decide_forms();
    decide_tf_table();
    decide_filters();
    decide_rays(statistics);
  } else {
    for (const FeatureName& feature : all_features()) reasons_.emplace_back(feature.in, nothing);
  }
  write_list();
  return std::move(need_);
}

}  // namespace

bool Need::is_empty() const { return !visible || !(features.dvr || features.peaks || features.statistics); }

int Need::passes() const {
  return features.long_rays ? std::max(1, (intervals - 1) / intervals_per_pass + 1) : 1;
}

Need find_need(const Volume& volume, const Classification& classification, const Rendering& rendering,
               const Camera& camera, glm::ivec2 size, bool statistics, const Forced& forced,
               const OccupiedShare& occupied_share) {
  if (const std::string why_not = why_inconsistent(rendering); !why_not.empty()) throw Error(why_not);
  const Box box = rendered_box(volume.grid, rendering.clip_box);
  const double spacing = volume.grid.smallest_spacing();
  const Scenery scenery{volume.grid,
                        volume.statistics,
                        classification,
                        rendering,
                        camera,
                        size,
                        box,
                        longest_ray(camera, box) / spacing,
                        step_lengths(rendering, camera, size, box, spacing)};
  return Decision(scenery, forced, occupied_share).make(statistics);
}

std::vector<GpuData> gpu_data(const Need& need, const Volume& volume, const Classification& classification) {
  std::vector<GpuData> data;
  const Features& f = need.features;
  const auto add = [&](const char* name, std::string size, std::size_t bytes) {
    data.push_back({name, std::move(size), bytes});
  };
  if (!f.dvr && !f.peaks) return data;
  const glm::ivec3 dims = volume.grid.dims;
  add("volume", fmt::format("{}x{}x{} points", dims.x, dims.y, dims.z),
      volume.grid.point_count() * sizeof(float));
  if (f.empty_cells) {
    const glm::ivec3 cells = dims - 1;
    add("empty_cells", fmt::format("{}x{}x{} cells", cells.x, cells.y, cells.z),
        std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z));
  }
  if (f.adaptive || f.skipping) {
    const int side = macrocell_side(volume.grid);
    const glm::ivec3 cells = (dims - 2 + side) / side;
    add("macrocells", fmt::format("{}x{}x{}, of {} cells a side", cells.x, cells.y, cells.z, side),
        std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z));
  }
  if (f.preintegration_table)
    add("preintegration_table", fmt::format("{0}x{0} bins", need.preintegration_bins),
        std::size_t(need.preintegration_bins) * std::size_t(need.preintegration_bins) * 4 * sizeof(float));
  else if (f.preintegrated)
    add("antiderivatives", fmt::format("{} entries", need.tf_table.entries + 1),
        std::size_t(need.tf_table.entries + 1) * sizeof(Antiderivatives::Entry));
  else if (f.dvr)
    add("transfer_function", fmt::format("{} entries", need.tf_table.entries),
        std::size_t(need.tf_table.entries) * 4 * sizeof(float));
  if (f.peaks) {
    const std::size_t count = need.needed.peaks ? classification.surfaces.size() : 1;
    add("surfaces", fmt::format("{}", count), count * 8 * sizeof(float));
  }
  if (f.peak_table) {
    const std::size_t cells = std::size_t(need.peak_bins) * std::size_t(need.peak_bins);
    add("peak_table", fmt::format("{0}x{0} bins", need.peak_bins), cells * 3 * sizeof(float));
  }
  return data;
}

}  // namespace crest
