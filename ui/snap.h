#pragma once

#include <optional>
#include <span>

#include "render/volume/volume.h"
#include "ui/edit_points.h"
#include "ui/value_axis.h"

namespace crest {

/// Where the volume's histogram, by its logarithm, has peaks that stand out by a seventh of its height.
std::vector<double> histogram_maxima(const VolumeStatistics& statistics);

/// Where a value may snap to: points that do not move, landmarks, and the marks on the axis.
std::vector<double> snap_places(const std::vector<ControlPoint>& points, const Selection& moving,
                                std::span<const double> landmarks, const ValueAxis& axis);

/// The nearest of them within `reach`.
std::optional<double> snapped(double value, double reach, std::span<const double> places);

}  // namespace crest
