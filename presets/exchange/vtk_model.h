#pragma once

#include <vector>

#include "presets/exchange/contributions.h"
#include "presets/exchange/exporters.h"

namespace crest {

/// The range that the target's tables span: the volume's, or without one that of the points; with a width.
ValueRange range_there(const ExportInput& input);

/// How VTK's GPU ray caster - in ParaView, 3D Slicer and F3D - goes about its work: a sample a voxel, from
/// the entry on, interpolated linearly; a ray ends at 254/255; it knows no peaks.
/// (vtkOpenGLGPUVolumeRayCastMapper, VTK 9.1.)
Preset in_vtk_settings(Preset preset);

/// The TF as it is drawn there when its points have these values. Opacity comes from a table over the data's
/// range: of 1024 entries, or up to 16384 where points are nearer to each other (vtkOpenGLVolumeLookupTable).
Preset drawn_by_vtk(const ExportInput& input, const std::vector<double>& values, double unit_distance);

/// The same for a script that draws the peaks as contours beside the volume.
Preset drawn_by_vtk_with_contours(const ExportInput& input, const ShownContributions& shown,
                                  const std::vector<double>& values);

/// The TF with these values as a table of `entries` over a range holds it, interpolated linearly.
TransferFunction tabled(const TransferFunction& tf, const std::vector<double>& values, ValueRange range,
                        int entries);

}  // namespace crest
