#pragma once

#include "render/measure/image_error.h"

namespace crest {

/// What a sparse picture tells of a full one's error. Both have the same camera, so that the sparse one's
/// rays are spread over what the full one shows.
struct SampledError {
  std::size_t rays = 0;  ///< that were compared
  double value = 0;      ///< in the sparse picture; NaN where nothing is known
  /// Between these lies the full picture's error, in about 98 of 100 pictures at either end, for one picture
  /// that is looked at once. 0 and infinity where a part of a picture does not tell.
  double low = 0, high = 0;
};

/// `is_whole`: the picture is the full one, and all is known. For measures of crossings, those of the picture
/// must be given.
///
/// share, missed and invented are proportions of rays, with Wilson's interval: of n rays with none wrong it
/// says at most 4 / (n + 4). p999 has the interval of a quantile, rmse that of a mean of squares, and of
/// errors of 1 that are too rare to be seen. A sparse picture
/// tells the least that `max` can be, and of `flip`, which is about neighbouring pixels, nothing.
SampledError sampled_error(const ErrorMeasure& measure, const Reference& exact, const Image& image,
                           std::span<const std::uint32_t> crossings, glm::vec3 background, bool is_whole);

/// What is known of whether a target is met.
enum class Verdict { met, unclear, missed };
Verdict judge(const SampledError& error, const TargetError& target);

}  // namespace crest
