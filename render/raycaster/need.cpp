#include "render/raycaster/need.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "presets/error.h"
#include "render/classify/antiderivatives.h"
#include "render/classify/peak_table.h"
#include "render/gl/filter_weights.h"
#include "render/raycaster/scene_facts.h"
#include "render/raycaster/sharpness.h"
#include "render/resources/shader_tf.h"
#include "render/scene/view.h"
#include "render/shader_inputs/blend_mode.h"
#include "render/volume/bricks.h"
#include "render/volume/macrocells.h"
#include "render/volume/whole_values.h"

namespace crest {
namespace {

/// Some drivers (Mesa's llvmpipe) end all loops of one invocation together after 65,535 rounds, in silence.
constexpr int most_loop_rounds = 60000;

int intervals_of(const SceneFacts& s, const Features& features) {
  if (features.analytic) return int(std::min(std::ceil(s.longest_ray) + 1, 2e9));
  return int(std::min(s.steps.most + 2.0 * s.spans(features), 2e9));
}

/// In a smallest spacing of its length a ray is in up to four cells, on average in no more than two; in each
/// it turns at most twice and meets levels, few of them on average. (Where it met more all along, a driver
/// that ends long loops would cut it off.)
int rounds_in_a_spacing(const SceneFacts& s) {
  const std::size_t levels = s.surfaces().size() + s.classification.tf.points.size();
  return 2 * (4 + int(std::min<std::size_t>(levels, 16)));
}

int intervals_per_pass(const SceneFacts& s, const Features& features) {
  if (features.analytic)
    return std::max(1, (most_loop_rounds - s.walk_rounds(features)) / rounds_in_a_spacing(s));
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
  Decision(const SceneFacts& facts, const Forced& forced, const OccupiedShare& occupied_share,
           const WeightError& weight_error)
      : s_(facts), forced_(forced), occupied_share_(occupied_share), weight_error_(weight_error) {}
  Need make(bool statistics);

 private:
  /// The feature is in unless there is a reason against it; also if it is forced in, where that is
  /// `harmless`.
  void decide(bool Features::*feature, std::string why_not, bool harmless = true) {
    need_.needed.*feature = why_not.empty();
    need_.features.*feature = why_not.empty() || (harmless && forced_.features.*feature);
    reasons_.emplace_back(feature, std::move(why_not));
  }
  /// Of what a march with samples needs: not where there are none.
  std::string where_sampled(std::string why_not) const {
    return need_.features.analytic ? "rays are solved from cell to cell" : std::move(why_not);
  }
  void decide_peaks();
  void decide_forms();
  void decide_tf_table();
  void decide_filters();
  std::string why_weights_do_not() const;
  void decide_steps();
  std::string why_no_skipping() const;
  void decide_rays(bool statistics);
  void write_list();

  const SceneFacts& s_;
  const Forced& forced_;
  const OccupiedShare& occupied_share_;
  const WeightError& weight_error_;
  std::string coarse_weights_;  ///< why the texture unit's weights do not do, if they do not
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
  decide(&Features::peak_table,
         unless_none(where_sampled(needs_table      ? ""
                                   : single.empty() ? few
                                                    : single)),
         f.peaks && !f.analytic);
  decide(&Features::peak_list, unless_none(where_sampled(f.peak_table ? "the peak table has them" : single)),
         f.peaks && !f.peak_table && !f.analytic);
  if (f.peak_table) {
    const int most = s_.rendering.peak_bins;
    need_.peak_bins = forced_.large_tables ? most : separating_bins(s_.surfaces(), s_.surface_field(), most);
  }
  decide(&Features::several_peaks, unless_none(where_sampled(s_.why_no_several_peaks(need_.peak_bins))),
         f.peaks && !f.analytic);
}

// The peak form decides what becomes of peaks and DVR, also where one of them was forced in.
void Decision::decide_forms() {
  const Features& f = need_.features;
  const std::string paper = where_sampled(s_.is_divided() ? "" : "the peak form is the paper's");
  const std::string none = f.peaks ? "" : s_.why_no_peaks();
  const std::string nothing_to_divide = !none.empty() ? none
                                        : f.dvr       ? ""
                                                      : "there is no DVR beside the peaks";
  decide(&Features::extrema, none.empty() ? paper : none, false);
  decide(&Features::split, nothing_to_divide.empty() ? paper : nothing_to_divide, false);
  decide(&Features::exclusive,
         !nothing_to_divide.empty()         ? nothing_to_divide
         : f.analytic                       ? where_sampled("")
         : !is_exclusive(s_.rendering.mode) ? "the mode is not PEAK_XOR_DVR"
         : s_.is_divided()                  ? "the peak form is split"
                                            : "",
         false);
}

void Decision::decide_tf_table() {
  decide(&Features::base_tf, need_.needed.dvr ? s_.why_no_base_tf() : s_.why_no_dvr(), false);
  const double spacing = s_.grid.smallest_spacing();
  if (need_.needed.dvr && !need_.features.analytic)
    need_.tf_table =
        tf_table_size(s_.dvr_tf(), s_.dvr_field(), spacing, glm::length(s_.grid.box_size()) / spacing);
  if (forced_.large_tables) need_.tf_table.entries = largest_tf_table;
  decide(&Features::preintegrated, s_.why_no_preintegration(), false);
  decide(&Features::preintegration_table, s_.why_no_preintegration_table(), false);
  if (need_.features.preintegration_table)
    need_.preintegration_bins =
        is_constant(s_.dvr_tf(), s_.dvr_field()) ? 2 : s_.rendering.preintegration_bins;
  if (!need_.needed.dvr || need_.features.analytic) return;
  need_.tf_blur = need_.features.preintegration_table
                      ? TableBlur{s_.dvr_field().width() / (need_.preintegration_bins - 1), s_.dvr_field()}
                      : tf_table_blur(s_.dvr_tf(), s_.dvr_field(), need_.tf_table.entries);
}

// The walk alone costs a tenth of a frame, and each run that a march begins anew some samples: where cells
// that show something lie scattered, leaving out the others pays below this share (bench_speed: "... % of the
// macrocells show").
constexpr double most_occupied = 0.5;

std::string Decision::why_no_skipping() const {
  if (!s_.rendering.skipping) return "rendering.skipping is false";
  if (shows_values(need_.needed.blend_mode)) return s_.blend_mode();
  if (!occupied_share_) return "no macrocells are known";
  const double share = occupied_share_(need_.needed, need_.tf_blur);
  return share <= (s_.is_in_bricks ? 1 : most_occupied)
             ? ""
             : fmt::format("{:.0f} % of the macrocells may show something", 100 * share);
}

void Decision::decide_steps() {
  const Sampling sampling = s_.rendering.sampling;
  if (need_.features.analytic) {
    for (const auto feature : {&Features::differential, &Features::footprint, &Features::adaptive})
      decide(feature, where_sampled(""), false);
    return decide(&Features::skipping, why_no_skipping());
  }
  const std::string name = fmt::format("rendering.sampling is {}", name_of(sampling));
  const Sampling taken = sampling_in(s_.camera, sampling);
  decide(&Features::differential, taken == Sampling::differential ? "" : name, false);
  decide(&Features::footprint,
         taken == Sampling::footprint ? ""
         : taken == sampling          ? name
                                      : "in parallel projection no pixel's footprint grows",
         false);
  decide(&Features::adaptive, s_.rendering.adaptive ? "" : "rendering.adaptive is false", false);
  decide(&Features::skipping, why_no_skipping(), !shows_values(need_.needed.blend_mode));
  if (has_equal_steps(sampling)) need_.features.placement = need_.needed.placement = s_.rendering.placement;
}

/// Samples may be off by what weights are rounded, times the difference of neighbours on each axis. Where
/// that changes what a segment adds by more than a step of an 8-bit picture, the TF shows it as stairs. (A
/// surface is misplaced by that, 1/512 of a voxel an axis: nobody sees it.)
std::string Decision::why_weights_do_not() const {
  constexpr double visible = 1.0 / 255, coarsest = 0x1p-9;  // weights of 8 bits
  const Filter filter = dvr_filter(s_.rendering).kind;
  if (!need_.needed.dvr || need_.features.analytic || !weight_error_) return "";
  if (filter != Filter::linear && filter != Filter::bspline) return "";
  if (shows_values(need_.needed.blend_mode)) return "";
  const glm::dvec3 steps = s_.statistics.largest_difference;
  const auto change = [&](double weight_error) {
    return largest_change_within(s_.dvr_tf(), s_.dvr_field(), weight_error * (steps.x + steps.y + steps.z),
                                 s_.steps.longest * s_.grid.smallest_spacing());
  };
  if (change(coarsest) <= visible) return "";  // on every driver: it is not asked
  const double error = weight_error_();
  const double most = error > 0 ? change(error) : 0;
  if (most <= visible) return "";
  return fmt::format(
      "the texture unit's weights have {} bits: what a sample adds would be off by up to {:.2g}",
      gl::weight_bits(error), most);
}

// One filter, unless both DVR and surfaces are there with different ones.
void Decision::decide_filters() {
  Features& f = need_.features;
  decide(&Features::own_root_filter, where_sampled(s_.why_no_own_root_filter(f)), false);
  f.filter = dvr_filter(s_.rendering).kind;
  f.root_filter = root_filter(s_.rendering).kind;
  coarse_weights_ = why_weights_do_not();
  if (!coarse_weights_.empty() && f.filter == Filter::linear) {
    f.filter = Filter::linear_exact;
    if (!f.own_root_filter) f.root_filter = f.filter;
  }
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
         if_sampled(shows_values(need_.needed.blend_mode)  ? s_.blend_mode()
                    : takes_gradient(s_.rendering.shading) ? ""
                                                           : "rendering.shading is none"),
         !shows_values(need_.needed.blend_mode));
  decide(&Features::filter_gradient, if_sampled(s_.why_no_filter_gradient(need_.features)),
         need_.features.shading && !need_.needed.shading);
  decide(&Features::whole_values, if_sampled(s_.has_whole_values ? "" : "the volume's values are floats"),
         false);
  decide(&Features::bricks, if_sampled(s_.is_in_bricks ? "" : "the device holds the whole volume"), false);
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
                               need_.features.analytic ? where_sampled("")
                               : !has_equal_steps(s_.rendering.sampling)
                                   ? fmt::format("rendering.sampling is {}", name_of(s_.rendering.sampling))
                               : s_.rendering.placement == Placement::entry_exit_corner
                                   ? "entry_exit_corner, the default, is the plain shader"
                                   : "nothing is sampled");
  if (need_.features.filter == Filter::linear && !need_.features.analytic)
    list.left_out.emplace_back("filter", "linear, the default, is the texture unit's");
  if (!coarse_weights_.empty() && need_.features.filter == Filter::linear_exact)
    list.left_out.emplace_back("filter_linear", coarse_weights_);
  if (!coarse_weights_.empty() && need_.features.filter == Filter::bspline)
    list.notes.push_back(fmt::format(
        "filter bspline: {}. The same field in float is bc with bc_b 1 and bc_c 0", coarse_weights_));
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
    decide(&Features::analytic, s_.why_no_analytic(), false);
    decide(&Features::dvr, s_.why_no_dvr());
    if (need_.needed.dvr) need_.features.blend_mode = need_.needed.blend_mode = s_.rendering.blend_mode;
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
               const OccupiedShare& occupied_share, const WeightError& weight_error, bool in_bricks) {
  if (const std::string why_not = why_inconsistent(rendering); !why_not.empty()) throw Error(why_not);
  const Box box = rendered_box(volume.grid, rendering.clip_box);
  const double spacing = volume.grid.smallest_spacing();
  SceneFacts facts{volume.grid,
                   volume.statistics,
                   whole_values(volume).has_value(),
                   in_bricks,
                   classification,
                   rendering,
                   camera,
                   size,
                   box,
                   longest_ray(camera, box) / spacing,
                   {}};
  if (!facts.why_no_analytic().empty()) facts.steps = step_lengths(rendering, camera, size, box, volume.grid);
  Need need = Decision(facts, forced, occupied_share, weight_error).make(statistics);
  need.longest_step = facts.steps.longest;
  return need;
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
      need.brick_count > 0 ? need.brick_count * brick_points * brick_points * brick_points * need.texel_bytes
                           : volume.grid.point_count() * need.texel_bytes);
  if (f.empty_cells) {
    const glm::ivec3 cells = dims - 1;
    add("empty_cells", fmt::format("{}x{}x{} cells", cells.x, cells.y, cells.z),
        std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z));
  }
  if (f.adaptive || f.skipping) {
    const int side = macrocell_side(volume.grid, volume.statistics);
    const glm::ivec3 cells = (dims - 2 + side) / side;
    add("macrocells", fmt::format("{}x{}x{}, of {} cells a side", cells.x, cells.y, cells.z, side),
        std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z));
  }
  if (f.analytic) {
    const auto& tf = f.base_tf ? classification.base : classification.tf;
    const auto surfaces = need.needed.peaks ? classification.surfaces : std::vector<Peak>();
    const std::size_t count =
        shader_tf(need.needed.dvr ? tf : TransferFunction{}, surfaces, volume.statistics.range, 1)
            .pieces.size();
    add("tf_pieces", fmt::format("{} pieces", count), count * sizeof(ShaderTfPiece));
  } else if (f.preintegration_table)
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
  if (f.peak_table)
    add("peak_table", fmt::format("{} bins", need.peak_bins),
        std::size_t(need.peak_bins) * 4 * sizeof(float));
  return data;
}

}  // namespace crest
