#pragma once

#include "presets/transfer_function.h"

namespace crest {

/// The most by which what a segment adds to a ray changes, in opacity or in a channel of its premultiplied
/// colour, if its value is off by up to `off`: over all values of `field`. The segment is `length` long, in
/// the units of the TF's unit distance. Exact but for what bends between two points. Takes O(points), and
/// more where many lie within `off` of each other.
double largest_change_within(const TransferFunction& tf, ValueRange field, double off, double length);

}  // namespace crest
