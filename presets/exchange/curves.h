#pragma once

#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// A point of a function of VTK's, which is linear, stepped or rounded towards the next point
/// (vtkPiecewiseFunction, vtkColorTransferFunction): the middle between both values is reached at `midpoint`
/// of the way, and `sharpness` leads from a line, 0, to a step, 1.
struct OpacityNode {
  double x = 0, opacity = 0, midpoint = 0.5, sharpness = 0;
};
struct ColorNode {
  double x = 0;
  glm::dvec3 color{0};
  double midpoint = 0.5, sharpness = 0;
};

/// What colours are interpolated in, by ParaView's names.
enum class ColorSpace { rgb, hsv, lab, diverging, step };

/// A TF that is the same within 1/255, in RGB and straight lines: exact where the nodes are. Nodes are sorted
/// by x (equal ones stay in their order). One of the two may be empty: then white, or clear.
TransferFunction straightened(std::vector<ColorNode> colors, std::vector<OpacityNode> opacities,
                              ColorSpace space);

/// The colour between two, at s in [0, 1]. Lab and Diverging as vtkColorTransferFunction has them (Moreland,
/// "Diverging Color Maps for Scientific Visualization", 2009), hue by the shorter way.
glm::dvec3 interpolate(const glm::dvec3& a, const glm::dvec3& b, double s, ColorSpace space);

/// A TF of colours (opacity is not looked at) and one of opacities, over the points of both.
TransferFunction merged(const TransferFunction& colors, const TransferFunction& opacities);

/// Without the points that lie on the line between their neighbours, to `tolerance` in opacity and each
/// colour.
TransferFunction simplified(const TransferFunction& tf, double tolerance);

}  // namespace crest
