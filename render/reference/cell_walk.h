#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#include "render/reference/value.h"

namespace crest::reference {

/// A ray in units of cells on each axis, from where it enters the box; its parameter is a length in smallest
/// spacings.
template <class Real>
struct CellRay {
  Vec3<Real> origin{0}, direction{0};
  Real length = 0;
};

/// A ray's part in one cell: where it enters, from 0 to 1 on each axis, and how far it goes.
template <class Real>
struct CellVisit {
  glm::ivec3 cell{0};
  Vec3<Real> entry{0}, extent{0};
  Real length = 0;
};

/// Calls visit(CellVisit) -> whether to go on, for each cell that the ray is in for a positive length, in
/// order: the next face on each axis is at t = (face - origin) / direction, and the nearest of the three is
/// crossed (Amanatides and Woo, A fast voxel traversal algorithm for ray tracing, 1987). A ray that runs in a
/// face is in the upper cell.
template <class Real, class Visit>
void walk_cells(glm::ivec3 cells, const CellRay<Real>& ray, Visit&& visit) {
  CellVisit<Real> at;
  Vec3<Real> next_face;
  const auto find_next_face = [&](int axis) {
    const Real d = ray.direction[axis];
    const Real face = Real(at.cell[axis] + (d > 0 ? 1 : 0));
    next_face[axis] = d == 0 ? std::numeric_limits<Real>::infinity() : (face - ray.origin[axis]) / d;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const Real start = ray.origin[axis], below = std::floor(start);
    const bool from_face_down = start == below && ray.direction[axis] < 0;
    at.cell[axis] = std::clamp(int(below) - (from_face_down ? 1 : 0), 0, cells[axis] - 1);
    find_next_face(axis);
  }
  Real t = 0;
  int entered = -1;  // the axis whose face was crossed last
  for (;;) {
    const int axis = next_face.x <= next_face.y ? (next_face.x <= next_face.z ? 0 : 2)
                                                : (next_face.y <= next_face.z ? 1 : 2);
    const Real end = std::min(next_face[axis], ray.length);
    if (end > t) {
      at.length = end - t;
      for (int a = 0; a < 3; ++a) {
        const Real place = ray.origin[a] + t * ray.direction[a] - Real(at.cell[a]);
        at.entry[a] = a == entered ? Real(ray.direction[a] > 0 ? 0 : 1) : std::clamp(place, Real(0), Real(1));
        at.extent[a] = ray.direction[a] * at.length;
      }
      if (!visit(at)) return;
      t = end;
    }
    if (!(next_face[axis] < ray.length)) return;
    at.cell[axis] += ray.direction[axis] > 0 ? 1 : -1;
    if (at.cell[axis] < 0 || at.cell[axis] >= cells[axis]) return;
    entered = axis;
    find_next_face(axis);
  }
}

}  // namespace crest::reference
