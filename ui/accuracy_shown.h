#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/measure/method_convergence.h"
#include "ui/accuracy_plot.h"
#include "ui/studio_state.h"

namespace crest {

/// What the accuracy panel shows: the results against one exact answer.
struct ShownAccuracy {
  const AccuracyResults& results;
  ExactAnswer answer;
  TargetError target;
  std::vector<MethodLine> lines{};
  std::vector<WorkPrecision> front{};  ///< what no other setting beats, by time
  std::vector<MethodConvergence> convergences{};
  std::optional<std::size_t> recommended{};  ///< the cheapest that meets the target, in what was measured
  Rendering base{};  ///< the document's settings, with the filters of what was measured: methods change these
  const Method* present = nullptr;  ///< as the document renders; null where none of methods() does so
  std::optional<WorkPrecision> present_point{};

  WorkPrecision point_of(std::size_t measured) const;
};
ShownAccuracy shown_accuracy(const AccuracyResults& results, AccuracyState& state,
                             const Rendering& rendering);

/// Gives the document a measured setting. Returns whether it changed.
bool apply_setting(Document& document, AccuracyState& state, const ShownAccuracy& shown,
                   std::size_t measured);

/// In words: the setting that is recommended, or that none meets the target, and the closest; empty while
/// nothing is shown.
std::string verdict_text(const ShownAccuracy& shown);

std::string step_text(double step);  ///< "1/4"
std::string ms_text(double ms);      ///< three digits

}  // namespace crest
