#pragma once

#include <cstdint>
#include <optional>

#include "ui/view_content.h"

namespace crest {

/// How two pictures are compared: one to the left of a line and the other to its right; their difference,
/// without its sign or with it; or one after the other.
enum class ComparisonKind { divider, difference, signed_difference, blink };

/// How long each picture is to be seen while they blink, in seconds.
inline constexpr double blink_s = 0.5;

/// A view beside another picture of the same volume, from the same camera.
struct Comparison {
  int view = 0;                ///< the one that is compared
  ViewContent with;            ///< the other
  std::optional<int> follows;  ///< the view that it is, also when that changes
  ComparisonKind kind = ComparisonKind::divider;
  float divider = 0.5F;      ///< its place, as a share of the width
  double amplification = 8;  ///< of a difference: 1 / this is white

  bool takes_difference() const {
    return kind == ComparisonKind::difference || kind == ComparisonKind::signed_difference;
  }
};

/// The difference of two pictures that are done.
struct DifferencePicture {
  std::uintptr_t texture = 0;  ///< 0 while one of them is not done
  /// Over all pixels, over their backgrounds: the root of the mean square, the greatest of a channel, and the
  /// share of those that differ by more than 1/255.
  double rmse = 0, max = 0, share = 0;
  bool is_measured = false;  ///< these numbers are of this picture; they come later than it does
  bool has_failed = false;   ///< they will not come
};

}  // namespace crest
