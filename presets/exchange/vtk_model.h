#pragma once

#include <vector>

#include "presets/exchange/exporters.h"

namespace crest {

/// How VTK's GPU ray caster - in ParaView, 3D Slicer and F3D - draws a TF whose points have these values. Its
/// opacity comes from a table over the data's range (without a volume, over that of the points): of 1024
/// entries, or up to 16384 where points are nearer to each other. It takes a sample a voxel, from the entry
/// on, ends a ray at 254/255, and knows no peaks. (vtkOpenGLVolumeLookupTable,
/// vtkOpenGLGPUVolumeRayCastMapper, VTK 9.1.)
Preset drawn_by_vtk(const ExportInput& input, const std::vector<double>& values, double unit_distance);

/// The TF as a table of `entries` over a range holds it, interpolated linearly.
TransferFunction tabled(const TransferFunction& tf, ValueRange range, int entries);

}  // namespace crest
