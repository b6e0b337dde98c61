#include "render/reference/exact_ray.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/reference/reference.h"

namespace crest {
namespace {

constexpr int parts_a_cell = 8;
/// What brings the most is sought among so many ranges of the values on the ray.
constexpr int pick_bins = 64;

}  // namespace

ExactRays::ExactRays(const Scene& scene, const Camera& camera, glm::ivec2 size, Answer answer,
                     std::shared_ptr<const reference::EmptyCells> known)
    : scene_(scene),
      solved_(reference::solved_scene<double>(scene_, answer, {}, true, std::move(known))),
      rays_(reference::pixel_rays(scene_.volume->grid, scene_.rendering.clip_box, camera, size)) {}

ExactRay ExactRays::at(glm::ivec2 pixel) const {
  const auto ray = reference::pixel_ray<double>(rays_, pixel.x, pixel.y);
  ExactRay result;
  if (!ray.inside) return result;
  const double unit = scene_.volume->grid.smallest_spacing();
  result.enter = ray.depth * unit;
  result.exit = result.enter + ray.inside->length * unit;
  reference::RaySolver<double> solver(solved_.levels.levels, default_tolerance);
  reference::trace_volume(
      solver, solved_.fields, solved_.levels, default_tolerance, ray, parts_a_cell,
      [&](const reference::TracedPlace& place) {
        const auto& found = solver.collected();
        result.places.push_back({result.enter + place.length * unit, place.value, found.color, found.alpha,
                                 place.crossed ? std::optional(place.crossed->value) : std::nullopt});
      });
  return result;
}

double ExactRay::value_at(double depth) const {
  const auto next = std::ranges::lower_bound(places, depth, {}, &RayPlace::depth);
  if (next == places.end()) return places.empty() ? std::nan("") : places.back().value;
  if (next == places.begin()) return next->value;
  const RayPlace& before = *std::prev(next);
  const double length = next->depth - before.depth;
  const double share = length > 0 ? (depth - before.depth) / length : 1;
  return before.value + share * (next->value - before.value);
}

double ExactRay::opacity_at(double depth) const {
  const auto behind = std::ranges::upper_bound(places, depth, {}, &RayPlace::depth);
  return behind == places.begin() ? 0 : std::prev(behind)->opacity;
}

Picked pick(const ExactRay& ray) {
  Picked picked;
  if (ray.places.empty() || !(ray.places.back().opacity > 0)) return picked;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const RayPlace& place : ray.places)
    if (!std::isnan(place.value)) {
      low = std::min(low, place.value);
      high = std::max(high, place.value);
    }
  struct Bin {
    double opacity = 0, value = 0, depth = 0;  // the last two weighted
  };
  std::vector<Bin> bins(pick_bins);
  const RayPlace* before = nullptr;
  for (const RayPlace& place : ray.places) {
    const double added = before ? place.opacity - before->opacity : 0;
    if (place.surface && !picked.surface) {
      picked.surface = place.surface;
      picked.surface_depth = place.depth;
    }
    if (added > 0 && !std::isnan(place.value)) {
      const double value = place.surface               ? *place.surface
                           : std::isnan(before->value) ? place.value
                                                       : (before->value + place.value) / 2;
      const double share = high > low ? (value - low) / (high - low) : 0;
      Bin& bin = bins[std::size_t(std::clamp(int(share * pick_bins), 0, pick_bins - 1))];
      bin.opacity += added;
      bin.value += added * value;
      bin.depth += added * place.depth;
    }
    before = &place;
  }
  const Bin& most = *std::ranges::max_element(bins, {}, &Bin::opacity);
  if (!(most.opacity > 0)) return picked;
  picked.strongest = most.value / most.opacity;
  picked.strongest_depth = most.depth / most.opacity;
  picked.strongest_share = most.opacity / ray.places.back().opacity;
  return picked;
}

}  // namespace crest
