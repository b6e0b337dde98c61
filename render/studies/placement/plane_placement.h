#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "presets/preset.h"
#include "render/measure/convergence.h"
#include "render/studies/placement/square.h"

namespace crest {

/// How a segment's emission counts: g dx, as the paper's eq. (6) has it, or g/tau (1 - exp(-tau dx)), with
/// what the segment itself absorbs of it, as the ray caster does.
enum class Sum { paper, absorbing };
std::string_view name_of(Sum sum);  ///< "paper", "absorbing"

/// The intensity of a ray from its samples, with g = s and tau = s/2.
double intensity(const Square& square, const PlaneRay& ray, Placement placement, double step, Sum sum);

/// Samples a spacing: the study's steps are Square::spacing / rate.
inline constexpr std::array<int, 7> study_rates{1, 2, 4, 8, 16, 32, 64};

/// Errors of a fan's rays that meet the square.
struct PlaneErrors {
  double max = 0, rms = 0;
  double least = 0, greatest = 0;  ///< signed: less than 0 is too dark
  int rays = 0, unsampled = 0;     ///< that meet the square; those of them without a sample
};

/// The fan through a square at one rate.
struct PlaneMeasurement {
  int rate = 1;
  std::vector<double> intensities;  ///< by ray of the paper's fan; 0 where it misses the square
  PlaneErrors errors;               ///< of these
  /// Of a fan with `dense` times as many rays: which ray is the worst is then no matter of chance.
  PlaneErrors dense_errors;
};
inline constexpr int dense = 40;

/// One placement with one sum, over all rates.
struct PlaneSeries {
  std::string_view field;  ///< "linear", "curved"
  Sum sum;
  Placement placement;
  std::vector<PlaneMeasurement> measurements;
  /// Of the dense fan's errors, over all rates; nothing where they are those of rounding.
  std::optional<OrderFit> max_order, rms_order;
};

struct PlaneStudy {
  struct Field {
    std::string_view name;
    std::vector<double> exact;  ///< by ray of the paper's fan; 0 where it misses the square
  };
  std::vector<Field> fields;
  std::vector<PlaneSeries> series;
};

/// Both fields, both sums, all placements.
PlaneStudy study_plane();

}  // namespace crest
