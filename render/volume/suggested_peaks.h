#pragma once

#include <vector>

#include "render/volume/by_value.h"

namespace crest {

/// A value at which a volume may have a boundary: there its gradient is, on the mean, steepest.
struct SuggestedPeak {
  double value = 0;
  double gradient = 0;     ///< the mean there, in value per world unit
  double persistence = 0;  ///< in (0, 1]: see suggest_peaks
};

/// A maximum has to stand out by this share of the greatest mean gradient.
inline constexpr double least_persistence = 0.05;

/// The maxima of the mean gradient by value, the most persistent first (Pekar et al., Fast detection of
/// meaningful isosurfaces for volume data visualization, 2001). A maximum's persistence is how far the curve
/// falls from it until it rises to a higher one (Edelsbrunner et al., Topological persistence and
/// simplification, 2002), and that of the highest how far it falls at all, as a share of the highest.
///
/// The mean is taken over five bins with binomial weights. Values that less than 1e-5 of the volume holds do
/// not count: their mean is of a few cells.
std::vector<SuggestedPeak> suggest_peaks(const ByValue& by_value, double least = least_persistence);

}  // namespace crest
