#include "render/raycaster/step_lengths.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "presets/choices.h"
#include "presets/error.h"
#include "presets/names.h"
#include "render/classify/occupancy.h"
#include "render/scene/camera.h"
#include "render/scene/view.h"

namespace crest {
namespace {

/// What is computed in float may be off by this share.
constexpr double slack = 1e-4;

/// The least |dD/dx| of the picture's rays (eq. 10), x in [-1,1] across a plane of these half sides: it is
/// U sqrt(1+q) / (1+p+q) with p = (xU)^2 and q = (yV)^2, falls with p, and has no minimum within q's range.
double least_spread(double u, double v) {
  const double p = u * u, q = v * v;
  return u * std::min(1 / (1 + p), std::sqrt(1 + q) / (1 + p + q));
}

/// How many steps T(x) = b x + a x(x-1)/2 takes from `near` over a length: T'' = a, and T' is
/// sqrt((b - a/2)^2 + 2 a T).
double differential_steps(double b, double a, double near, double length) {
  const double step = std::sqrt((b - a / 2) * (b - a / 2) + 2 * a * near);
  return 2 * length / (step + std::sqrt(step * step + 2 * a * length));
}

double longest_equal_step(const Rendering& rendering) {
  switch (rendering.placement) {
    case Placement::eye:
    case Placement::entry:
      // Pre-integrated segments take in what is left over at the span's ends
      return is_preintegrated(rendering.classification) ? 2 * rendering.step : rendering.step;
    case Placement::entry_exit:
      return 2 * rendering.step;
    case Placement::entry_exit_corner:
      break;
  }
  return rendering.step;
}

}  // namespace

StepLengths step_lengths(const Rendering& rendering, const Camera& camera, glm::ivec2 size, const Box& box,
                         const Grid& grid) {
  if (box.is_empty()) return {};
  const double smallest_spacing = grid.smallest_spacing();
  const double ray = longest_ray(camera, box) / smallest_spacing;
  const double near = glm::length(camera.eye - glm::clamp(camera.eye, box.min, box.max)) / smallest_spacing;
  const double far = near + glm::length(box.max - box.min) / smallest_spacing;
  // Half the image plane's width and height at distance 1, or in parallel projection none of what it grows by
  const glm::dvec2 plane = half_height(camera).slope * glm::dvec2(aspect_of(size), 1);
  const glm::dvec2 pixel = 2.0 / glm::dvec2(size);
  const double k = rendering.s_k * ray_frame(camera, grid, size).pixel;
  const glm::dvec2 spread(least_spread(plane.x, plane.y), least_spread(plane.y, plane.x));
  StepLengths lengths;
  switch (sampling_in(camera, rendering.sampling)) {
    case Sampling::uniform:
      lengths.longest = longest_equal_step(rendering);
      lengths.most = std::ceil(ray * (1 + slack) / rendering.step);
      break;
    case Sampling::differential:
      lengths.longest = std::sqrt(k * k + 2 * k * plane.x * far) + 2 * k * plane.x;
      lengths.most = differential_steps(k, k * spread.x, near, ray);
      break;
    case Sampling::footprint:
      lengths.longest = k * (far + 1);
      lengths.most = std::log1p(ray / (near + 1)) / std::log1p(rendering.s_k * glm::length(spread * pixel));
      break;
  }
  lengths.longest *= (1 + slack) * (rendering.adaptive ? most_joined_steps : 1);
  lengths.most = std::ceil(lengths.most * (1 + slack)) + 2;
  if (std::isnan(lengths.most)) throw Error("camera.eye or camera.target is too far away to be drawn from");
  if (!(lengths.most <= most_segments))
    throw Error(fmt::format(
        "sampling '{}' would take {:.2g} steps a ray {}: a larger s_k, or {}'uniform' sampling, takes fewer",
        name_of(rendering.sampling), lengths.most, plane.y > 0 ? "from so far away" : "with so small a pixel",
        plane.y > 0 ? "'footprint' or " : ""));
  return lengths;
}

}  // namespace crest
