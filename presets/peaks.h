#pragma once

#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// A control point (or narrow plateau) that is a peak of the TF, or that a person made a surface.
struct Peak {
  double value = 0;  ///< the isovalue of its surface
  glm::dvec3 color{1};
  double opacity = 0;                           ///< of its surface: what one crossing absorbs
  double width = 0;                             ///< between its neighbours' values
  double prominence = 0;                        ///< topographic, in opacity
  std::size_t first_point = 0, last_point = 0;  ///< the control points that it is made of
  std::size_t left = 0, right = 0;              ///< the control points where its flanks end
  bool detected = false;                        ///< by the peak rule
  bool shown = false;  ///< as a surface: detected or switched on, and not switched off
  bool spike = false;  ///< detected, and no wider than the TF's spike_width
  bool operator==(const Peak&) const = default;
};

/// All peaks, and all points that are switched on, by ascending value; also those not shown, to be listed.
/// A peak is an inner point whose opacity is strictly greater than both its neighbours', with neither
/// neighbour at its value unless both are; its prominence is at least min_prominence. Points on the straight
/// line of a flank change nothing: neighbours are where the flanks end. (Knoll et al. 2009, section 4.1.)
/// Points of one plateau, and the same point twice, are one peak: hidden if any of them is switched off, with
/// the first surface opacity that one of them has. Takes O(n log n).
std::vector<Peak> find_peaks(const TransferFunction& tf);

/// Those that are shown, by ascending value.
std::vector<Peak> shown_peaks(const std::vector<Peak>& peaks);

/// `peaks` are those of `tf`. The TF with each spike that is shown as a surface taken out, its neighbours
/// joined by a line.
TransferFunction base_transfer_function(const TransferFunction& tf, const std::vector<Peak>& peaks);

}  // namespace crest
