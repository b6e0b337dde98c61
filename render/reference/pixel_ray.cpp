#include "render/reference/pixel_ray.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace crest::reference {
namespace {

template <class Real>
struct Span {
  Real enter, exit;
  int axis = -1;  ///< whose face is entered
};

/// Where the line is in the box, from `start` on. A line in a face is inside; nothing is in a box that ends
/// before it begins.
template <class Real>
Span<Real> intersect(Vec3<Real> origin, Vec3<Real> direction, Vec3<Real> low, Vec3<Real> high, Real start) {
  Span<Real> hit{start, std::numeric_limits<Real>::max()};
  for (int axis = 0; axis < 3; ++axis) {
    const Real o = origin[axis], d = direction[axis];
    if (low[axis] > high[axis]) return {1, 0};
    if (d == 0) {
      if (o < low[axis] || o > high[axis]) return {1, 0};
      continue;
    }
    const Real a = (low[axis] - o) / d, b = (high[axis] - o) / d;
    if (std::min(a, b) > hit.enter) {
      hit.enter = std::min(a, b);
      hit.axis = axis;
    }
    hit.exit = std::min(hit.exit, std::max(a, b));
  }
  return hit;
}

}  // namespace

PixelRays pixel_rays(const Grid& grid, const std::optional<ClipBox>& clip, const Camera& camera,
                     glm::ivec2 size) {
  PixelRays rays;
  rays.frame = ray_frame(camera, grid, size);
  rays.size = size;
  rays.cell_size = grid.spacing / grid.smallest_spacing();
  rays.cells = grid.dims - 1;
  const Box box = rendered_box(grid, clip), whole{grid.box_min(), grid.box_max()};
  for (int axis = 0; axis < 3; ++axis) {
    const auto in_cells = [&](double place) { return (place - grid.origin[axis]) / grid.spacing[axis]; };
    rays.low[axis] = box.min[axis] > whole.min[axis] ? in_cells(box.min[axis]) : 0;
    rays.high[axis] = box.max[axis] < whole.max[axis] ? in_cells(box.max[axis]) : rays.cells[axis];
  }
  return rays;
}

template <class Real>
PixelRay<Real> pixel_ray(const PixelRays& rays, int x, int y) {
  using Vector = Vec3<Real>;
  const RayFrame& frame = rays.frame;
  const Real px = Real(2 * (x + 0.5) / rays.size.x - 1), py = Real(1 - 2 * (y + 0.5) / rays.size.y);
  const Vector cell(rays.cell_size), low(rays.low), high(rays.high);
  const Vector through = Vector(frame.w) + px * Vector(frame.u) + py * Vector(frame.v);
  const Real size = glm::length(through);
  const Vector direction = through / size / cell;
  const Vector origin =
      (Vector(frame.anchor) + px * Vector(frame.anchor_u) + py * Vector(frame.anchor_v)) / cell;
  const Real eye = Real(-frame.eye_to_anchor) * size;

  PixelRay<Real> ray;
  // A float position is a product and a sum of numbers no larger than the box and the origin: four roundings.
  ray.float_rounding = 0x1p-22 * glm::max(glm::dvec3(rays.cells), glm::abs(glm::dvec3(origin)));
  const Vector margin(ray.float_rounding);
  const auto wide = intersect<Real>(origin, direction, low - margin, high + margin, eye);
  const auto narrow = intersect<Real>(origin, direction, low + margin, high - margin, eye);
  ray.grazes_box = wide.exit >= wide.enter && !(narrow.exit > narrow.enter);

  const auto hit = intersect<Real>(origin, direction, low, high, eye);
  if (!(hit.exit > hit.enter)) return ray;
  ray.inside = CellRay<Real>{origin + hit.enter * direction, direction, hit.exit - hit.enter};
  ray.depth = double(hit.enter - eye);
  if (hit.axis >= 0) ray.inside->origin[hit.axis] = direction[hit.axis] > 0 ? low[hit.axis] : high[hit.axis];
  return ray;
}

template PixelRay<double> pixel_ray<double>(const PixelRays&, int, int);
template PixelRay<float> pixel_ray<float>(const PixelRays&, int, int);

}  // namespace crest::reference
