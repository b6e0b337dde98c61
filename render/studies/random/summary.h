#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/studies/random/measure.h"

namespace crest {

/// What a method's pictures at one step are off by, all scenes' pixels together.
struct StepSummary {
  double step = 0;  ///< 0 for a method without one
  int scenes = 0;   ///< with a pixel that could be compared
  double pixels = 0, wrong = 0, outliers = 0;
  double rmse = 0, max = 0;
  int worst_scene = -1;     ///< with the least share of its pixels within 1/255
  double worst_within = 1;  ///< that share
  std::optional<ImageError::Crossings> crossings;

  double within() const;  ///< share of the pixels within 1/255; NaN where none was compared
};

/// A method against one of the exact answers of its mode, over some scenes.
struct MethodSummary {
  std::string method;  ///< Method::id
  ExactAnswer answer;
  std::vector<StepSummary> steps;  ///< from coarse to fine
  /// From each step to the next one: by which power of the step the RMSE falls. Nothing where it is that of
  /// rounding.
  std::vector<std::optional<double>> orders;
};

/// One for each method and answer, in the order in which they appear, of the scenes that are asked for.
std::vector<MethodSummary> summarize(std::span<const RandomMeasurement> measurements,
                                     const std::function<bool(int scene)>& is_asked_for);

/// Of the methods with a step that show surfaces and volume once (`base+crossings`) of the trilinear field,
/// the one with the least share of wrong pixels at its finest step; of several, at the one before. Null where
/// there is none.
const MethodSummary* best_sampled(std::span<const MethodSummary> summaries);

/// That of a method against its first answer; null where it is not there.
const MethodSummary* find_summary(std::span<const MethodSummary> summaries, std::string_view method);

}  // namespace crest
