#pragma once

#include <string>
#include <vector>

#include "render/studies/knoll/results.h"

namespace crest {

enum class Verdict { not_measured, holds, better, worse };
std::string_view name_of(Verdict verdict);

/// What a claim says of a number: that it lies in a range, and which side of it is the better one.
struct ClaimedRange {
  double low = 0, high = 0;
  bool less_is_better = false;
};

/// A number that was measured for a claim, and of what.
struct Evidence {
  std::string of;  ///< "heptane (fig. 3)"
  double value = 0;
};

/// A claim of the paper against what was measured.
struct ClaimCheck {
  std::string id, claim, quantity;
  ClaimedRange paper;
  std::vector<Evidence> evidence;
  Verdict verdict = Verdict::not_measured;
  std::string why;  ///< a sentence: what the numbers say of where it differs

  double least() const;  ///< of the evidence
  double greatest() const;
};

/// Frame times of interleaved frames of a shader against itself differ by as much.
inline constexpr double claim_tolerance = 0.05;

/// Worse where one number lies beyond the range's bad end; else better where one lies beyond the good end;
/// else it holds. Ends count with claim_tolerance.
Verdict judge(const ClaimedRange& paper, const std::vector<Evidence>& evidence);

/// All claims, in the paper's order. One that nothing was measured for is not_measured, and says so.
std::vector<ClaimCheck> check_claims(const KnollResults& results);

/// The median over the rounds of one shot's time by another's in the same round.
double time_ratio(const Shot& a, const Shot& b);

}  // namespace crest
