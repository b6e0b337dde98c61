#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "render/scene/scene.h"

namespace crest::stability {

using VolumePtr = std::shared_ptr<const Volume>;

/// n points an axis, one apart, from the origin.
Grid cube(int n);

/// The field of a formula of the world position, and one of values, x fastest.
VolumePtr make_volume(const Grid& grid, const std::function<double(glm::dvec3)>& formula);
VolumePtr make_volume(const Grid& grid, std::vector<float> values);

ControlPoint point(double value, double opacity, glm::dvec3 color = glm::dvec3(1));

/// A resolved TF of these points.
TransferFunction make_tf(std::vector<ControlPoint> points, double unit_distance = 1);

/// A TF that is clear but for peaks of one opacity at these ascending values, each 2 * half_width wide; 0
/// makes true spikes.
TransferFunction peaks_at(const std::vector<double>& values, double opacity, double half_width = 0);

Scene make_scene(VolumePtr volume, TransferFunction tf, Mode mode, double step = 0.5);

/// Looks along +z at the middle of the box, from so far that all rays are parallel in effect; `extent` is the
/// picture's height in world units.
Camera along_z(const Grid& grid, double extent);

/// A closed, curved field of few levels, so that its values can be scaled and shifted without rounding: the
/// gyroid in multiples of 1/64, on n points an axis.
VolumePtr gyroid_in_levels(int n = 24);

/// Haze with a wide peak (that keeps its body) and a spike, over the whole of `range`.
TransferFunction haze_and_peaks(ValueRange range, double unit_distance);

/// Haze of one material, blue, with a red surface in it that is a true spike: for a constant haze sampling is
/// exact at any step, so that what is off is not the step's. In DVR_ONLY there is no spike.
TransferFunction haze_with_surface(ValueRange range, double isovalue, double haze_opacity,
                                   double surface_opacity, double unit_distance, Mode mode);

/// The step of the invariances: so short that a crossing may fall before a sample or after it, as rounding
/// has it, without being seen (at half a voxel that changes one pixel in 1e5 by 1e-3).
inline constexpr double fine_step = 1.0 / 64;

/// The modes that a case is tested in.
inline constexpr Mode tested_modes[] = {Mode::dvr_only, Mode::peak_only, Mode::peak_xor_dvr, Mode::both};

}  // namespace crest::stability
