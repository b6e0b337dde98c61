#pragma once

#include <string>
#include <vector>

#include "presets/transfer_function.h"

namespace crest {

/// A colour map that is ready to be put on a TF: presets/color_maps/color_maps.json.
struct ColorMap {
  std::string name, source;     ///< where its numbers were published
  TransferFunction colors;      ///< over 0..1, or where `in_data_values` over the data's own; without opacity
  bool in_data_values = false;  ///< of a CT: Hounsfield units
  std::vector<glm::dvec3> distinct;  ///< of a qualitative map instead: one for each peak, in turn
};

/// All of them, in the order in which they are offered.
std::vector<ColorMap> color_maps();

/// The TF with the map's colours at its points, opacities untouched. A map over 0..1 is laid over the points'
/// range; one in data values is looked up in those of the volume, whose range `volume` is, where the TF is
/// normalized. A qualitative one gives each peak, with the points of its flanks, a colour of its own; other
/// points keep theirs.
TransferFunction with_color_map(const TransferFunction& tf, const ColorMap& map, ValueRange volume);

}  // namespace crest
