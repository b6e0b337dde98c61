#pragma once

#include "render/files/image.h"
#include "render/scene/scene.h"
#include "tests/changed_shaders.h"

namespace crest::bench {

// The sweep of Weiss and Westermann, "Analytic Ray Splitting for Controlled Precision DVR" (EuroVis 2021), in
// Crest's terms: a tent of extinction about an isovalue, that narrows while the light it takes stays the
// same.

/// Half widths of the tents, in shares of the volume's range: 0.05 to 0.002, linear in their power of 0.1.
std::vector<double> tent_widths(int count);

/// Extinction rises linearly from 0 at `isovalue` - `width` to a tip, and falls again; both in shares of the
/// volume's range. The tip is `scaling` * 0.05 / width, for a longest side of the box of 1, as theirs.
///
/// Crest's opacity a is linear between points, and extinction is -ln(1 - a) / unit_distance. A tip of
/// a = 0.001 leaves extinction linear to 0.05 %; the unit distance is such that its integral over the tent's
/// values is to the letter that of the linear one.
TransferFunction tent(const Volume& volume, double isovalue, double width, double scaling);

/// What a texture of so many texels over the range shows of it, interpolated linearly between their centres.
TransferFunction as_texture(const TransferFunction& tf, ValueRange range, int texels);

/// Shaders whose post-classification is their "stepping": samples at the beginnings of whole steps from the
/// entry, opacity = extinction * step, at most 1, in place of the exponential; what has an extinction of 1e-4
/// or less, for a longest side of 1, is skipped. With it go placement `entry`, an early termination of 0.001
/// and a TF as_texture() of 512 texels.
ChangedShaders stepping_shaders(const Grid& grid);

/// How far two pictures over white are apart, each channel in [0, 1].
struct WhiteError {
  double mean = 0;     ///< of all pixels and channels
  double largest = 0;  ///< of any channel
  double share = 0;    ///< of all pixels, those with a channel that is off by more than 1/255
};
WhiteError error_over_white(const Image& a, const Image& b);

}  // namespace crest::bench
