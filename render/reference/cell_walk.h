#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#include "render/reference/field_degrees.h"
#include "render/reference/levels.h"
#include "render/reference/polynomial.h"

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

/// Calls visit(CellVisit) -> whether to go on, for each cell that the ray is in for a positive length
/// (Amanatides and Woo 1987). A ray that runs in a face is in the upper cell.
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

/// The trilinear field along the ray's part in a cell, less the first corner's value; `corner` x fastest. One
/// axis at a time: so a face of equal values gives exactly that value.
template <class Real>
Polynomial<Real, cell_degree> field_along(const float (&corner)[8], const CellVisit<Real>& at) {
  Real c[8];
  for (int i = 0; i < 8; ++i) c[i] = Real(corner[i]) - Real(corner[0]);
  Polynomial<Real, 1> line[4];
  for (int i = 0; i < 4; ++i) {
    const Real step = c[i + 4] - c[i];
    line[i].c = {c[i] + step * at.entry.z, step * at.extent.z};
  }
  Polynomial<Real, 2> square[2];
  for (int i = 0; i < 2; ++i) {
    const auto &a = line[i].c, &b = line[i + 2].c;
    const Real step = b[0] - a[0], tilt = b[1] - a[1];
    square[i].c = {a[0] + step * at.entry.y, a[1] + tilt * at.entry.y + step * at.extent.y,
                   tilt * at.extent.y};
  }
  const auto &a = square[0].c, &b = square[1].c;
  const Real step = b[0] - a[0], tilt = b[1] - a[1], bend = b[2] - a[2];
  return {{a[0] + step * at.entry.x, a[1] + tilt * at.entry.x + step * at.extent.x,
           a[2] + bend * at.entry.x + tilt * at.extent.x, bend * at.extent.x}};
}

}  // namespace crest::reference
