#pragma once

#include <functional>

namespace crest {

/// Told how much of some work is done, as a share in [0, 1] that never becomes less, by the thread that does
/// it. Empty where nobody asks.
using TellShare = std::function<void(double share)>;

inline void tell(const TellShare& progress, double share) {
  if (progress) progress(share);
}

/// For a part of the work, which is [begin, end] of the whole.
inline TellShare share_of(const TellShare& whole, double begin, double end) {
  if (!whole) return {};
  return [=](double share) { whole(begin + (end - begin) * share); };
}

}  // namespace crest
