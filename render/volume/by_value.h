#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "render/volume/volume.h"

namespace crest {

/// What a volume has at each value, in equal bins over its range: how much of its space holds such values,
/// and the integral of the gradient's length over that space. The other curves follow from the two.
///
/// The estimator: each cell without a corner that is NaN or infinite is cut into six tetrahedra about its
/// diagonal (Kuhn), in which the field is taken to be linear. There both sums are exact: the share of a
/// tetrahedron below a value is a cubic of the value, and the gradient is one vector. By the co-area formula,
///
///   integral from a to b of area(v) dv  =  integral of |grad f| over { x : a <= f(x) < b },
///
/// a bin's area is the mean area of the isosurfaces in it: no triangles are made, and none is lost between
/// two bins (Scheidegger et al., Revisiting histograms and isosurface statistics, 2008).
///
/// Its bias: none for a linear field. The linear pieces leave the field between the points by the order of
/// the spacing squared, times the second derivatives; areas, gradients and volumes are off by that order (a
/// sphere of radius 6 spacings: under 1 %). Detail between two points is smoothed away, as everywhere.
struct ByValue {
  ValueRange range;
  std::vector<double> volume;    ///< world units^3
  std::vector<double> gradient;  ///< integral of |grad f|: value * world units^2

  std::size_t bins() const { return volume.size(); }
  double bin_width() const { return range.width() / double(bins()); }
  double middle(std::size_t bin) const { return range.min + bin_width() * (double(bin) + 0.5); }
};

inline constexpr int by_value_bins = 512;

/// O(cells) and the bins that each spans; on all cores; the result does not depend on how many. Nothing when
/// it was stopped.
std::optional<ByValue> measure_by_value(const Volume& volume, int bins = by_value_bins,
                                        const std::stop_token& stop = {});

/// Each bin's mean area of an isosurface, in world units^2. 0 where the range has no width.
std::vector<double> surface_area(const ByValue& by_value);
/// Each bin's mean length of the gradient, in value per world unit; 0 where nothing has such values.
std::vector<double> mean_gradient(const ByValue& by_value);
/// The space with values from each bin's lower end on, in world units^3.
std::vector<double> enclosed_volume(const ByValue& by_value);

}  // namespace crest
