#pragma once

#include <stop_token>
#include <vector>

#include "render/raycaster/raycaster.h"
#include "render/studies/stability/row.h"

namespace crest::stability {

/// What a case works with: the ray caster that is tested, and the size of the pictures that do not ask for
/// one of their own.
struct Lab {
  Raycaster& raycaster;
  glm::ivec2 size{64, 64};
  std::stop_token stop = {};  ///< what draws then throws Cancelled

  Image draw(const Scene& scene, const Camera& camera) const { return draw(scene, camera, size); }
  Image draw(const Scene& scene, const Camera& camera, glm::ivec2 pixels) const;
};

/// A picture, and how many crossings and DVR samples each of its pixels has.
struct CountedPicture {
  Image image;
  std::vector<unsigned> crossings, dvr_samples;
};
CountedPicture draw_counted(const Lab& lab, const Scene& scene, const Camera& camera, glm::ivec2 pixels);

/// A picture against the exact one of its scene's mode. Pixels whose rays graze a surface within float
/// rounding are left out: there a crossing more or less is right; and those that are named.
struct Deviation {
  double largest = 0;  ///< error of a channel
  int missed = 0;      ///< crossings, over all pixels
  /// Pixels with more crossings than there are, or an odd number too few: what a step passes over it passes
  /// over in pairs, in and out again.
  int miscounted = 0;
  int left_out = 0;
};
Deviation deviation_from_exact(const CountedPicture& picture, const Scene& scene, const Camera& camera,
                               const std::vector<bool>& left_out = {});

/// The largest difference of a channel; infinite where either is NaN.
double largest_difference(const Image& a, const Image& b, const std::vector<bool>& left_out = {});
double largest_difference(const Image& a, const std::vector<glm::dvec4>& truth,
                          const std::vector<bool>& left_out = {});

/// The same, divided by the larger of truth's channel and `floor`.
double largest_relative_difference(const Image& a, const std::vector<glm::dvec4>& truth,
                                   double floor = 1e-30);

/// Pixels that are not equal bit for bit.
int unequal_pixels(const Image& a, const Image& b);

}  // namespace crest::stability
