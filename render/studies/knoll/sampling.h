#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/studies/knoll/lab.h"

namespace crest {

/// The longest step with at most this error: `error` is asked at steps that are halved and doubled from 1,
/// then bisected in the logarithm until it lies within 2 % of the step. Nothing where even `shortest` does
/// not do. An error that is not monotone may have longer steps that do, beyond one that does not.
std::optional<double> longest_step_within(double most_error, const std::function<double(double)>& error,
                                          double shortest, double longest);

/// The step at which `ratio`, of some cost to what it should be, is 1 within `tolerance`, found by turns of
/// step *= ratio, as a cost is nearly in proportion to 1 / step; the best of `turns`.
double step_of_equal_cost(double first, const std::function<double(double)>& ratio, double tolerance,
                          int turns, double shortest, double longest);

/// Table 2 of Knoll et al. 2009: uniform against differential sampling.
enum class HeldConstant { frame_rate, quality };

/// What the paper prints of a row.
struct PaperSampling {
  double fps_uniform = 0, fps_differential = 0, samples_uniform = 0, samples_differential = 0;
};

struct SamplingRow {
  HeldConstant held = HeldConstant::quality;
  std::string scene, method;  ///< ids; method: "post", "xor", "xor-bspline", "post-bspline"
  PaperSampling paper;
  ShotGroup shots;      ///< "uniform", "differential"
  bool reached = true;  ///< else uniform sampling does not come to the same error at the shortest step

  const Shot& uniform() const { return shots.shots[0]; }
  const Shot& differential() const { return shots.shots[1]; }
  double speed_up() const { return 1 / differential().ratio; }
};

/// The id of such a row's shots: "aneurism-far-post-bspline-quality".
std::string sampling_group_id(HeldConstant held, std::string_view scene, std::string_view method);

/// A row: differential sampling as the variant has it, and uniform sampling with the step that holds what is
/// held.
SamplingRow compare_sampling(KnollLab& lab, const KnollScene& scene, HeldConstant held, const Variant& method,
                             bool with_pictures);

/// In smallest spacings, between which steps are looked for.
inline constexpr double shortest_uniform_step = 1.0 / 32, longest_uniform_step = 8;

}  // namespace crest
