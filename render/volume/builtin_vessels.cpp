#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "render/volume/builtin_fields.h"
#include "render/volume/random.h"

namespace crest {
namespace {

/// A piece of a tube, between two points, its radius changing linearly.
struct Piece {
  glm::dvec3 a, b;
  double radius_a, radius_b;
};

constexpr int cells = 16;  ///< on each axis of the table that says which pieces are near

/// The pieces, and for each cell of the cube those that reach into it.
struct Tree {
  std::vector<Piece> pieces;
  std::vector<std::vector<int>> near{std::size_t(cells * cells * cells)};

  static int cell_of(double x) { return std::clamp(int((x + 1) / 2 * cells), 0, cells - 1); }
  const std::vector<int>& near_point(glm::dvec3 p) const {
    return near[std::size_t(cell_of(p.x) + cells * (cell_of(p.y) + cells * cell_of(p.z)))];
  }

  void add(const Piece& piece) {
    const double radius = std::max(piece.radius_a, piece.radius_b);
    const glm::dvec3 low = glm::min(piece.a, piece.b) - radius, high = glm::max(piece.a, piece.b) + radius;
    for (int k = cell_of(low.z); k <= cell_of(high.z); ++k) {
      for (int j = cell_of(low.y); j <= cell_of(high.y); ++j) {
        for (int i = cell_of(low.x); i <= cell_of(high.x); ++i) {
          near[std::size_t(i + cells * (j + cells * k))].push_back(int(pieces.size()));
        }
      }
    }
    pieces.push_back(piece);
  }
};

glm::dvec3 random_direction(Random& random) {
  const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// A branch that wanders, turns back from the cube's faces, and ends in two thinner ones (Murray's law: the
/// cubes of the radii add up).
void grow(Tree& tree, Random& random, glm::dvec3 at, glm::dvec3 direction, double radius, double least_radius,
          int generations) {
  constexpr int steps = 8;
  constexpr double wander = 0.35, margin = 0.88;
  const double step = 0.055 + 0.35 * radius, end_radius = std::max(radius * 0.86, least_radius);
  for (int i = 0; i < steps; ++i) {
    direction += wander * random_direction(random);
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(at[axis]) > margin - 0.2 && at[axis] * direction[axis] > 0) direction[axis] *= -0.3;
    }
    direction = glm::normalize(direction);
    const glm::dvec3 next = glm::clamp(at + direction * step, -margin, margin);
    tree.add({at, next, std::lerp(radius, end_radius, double(i) / steps),
              std::lerp(radius, end_radius, double(i + 1) / steps)});
    at = next;
  }
  if (generations <= 1) return;
  const double share = random.uniform(0.35, 0.65);
  const glm::dvec3 side = glm::normalize(glm::cross(direction, random_direction(random)));
  for (const auto& [part, way] : {std::pair(share, 1.0), std::pair(1 - share, -1.0)}) {
    grow(tree, random, at, glm::normalize(direction + 1.2 * way * side),
         std::max(end_radius * std::cbrt(part), least_radius), least_radius, generations - 1);
  }
}

/// (distance / radius)^2 from a piece, at its nearest point.
template <class T>
T distance_ratio(const Point<T>& p, const Piece& piece) {
  const glm::dvec3 along = piece.b - piece.a;
  const T x = p.x - piece.a.x, y = p.y - piece.a.y, z = p.z - piece.a.z;
  T t = (x * along.x + y * along.y + z * along.z) / std::max(glm::dot(along, along), 1e-12);
  if (value_of(t) < 0) t = 0.0;
  if (value_of(t) > 1) t = 1.0;
  const T dx = x - t * along.x, dy = y - t * along.y, dz = z - t * along.z;
  const T radius = piece.radius_a + t * (piece.radius_b - piece.radius_a);
  return (dx * dx + dy * dy + dz * dz) / (radius * radius);
}

}  // namespace

/// 1 on a tube's axis, and smoothly to 0 at its radius: (1 - (d/r)^2)^2; exactly 0 outside.
FormulaField vessel_field(const VesselShape& shape, std::uint64_t seed) {
  const auto tree = std::make_shared<Tree>();
  Random random(seed);
  const glm::dvec3 root(random.uniform(-0.3, 0.3), -0.88, random.uniform(-0.3, 0.3));
  grow(*tree, random, root, {0, 1, 0}, shape.radius, shape.radius / 5, shape.generations);
  const glm::dvec3 bulge = tree->pieces[7].b;  // at the end of the trunk, where it branches
  tree->add({bulge, bulge, 2.2 * shape.radius, 2.2 * shape.radius});

  return field_of([tree](const auto& p) {
    using T = std::decay_t<decltype(p.x)>;
    T nearest = 1.0;
    for (const int index : tree->near_point({value_of(p.x), value_of(p.y), value_of(p.z)})) {
      const T ratio = distance_ratio(p, tree->pieces[std::size_t(index)]);
      if (value_of(ratio) < value_of(nearest)) nearest = ratio;
    }
    return (1.0 - nearest) * (1.0 - nearest);
  });
}

}  // namespace crest
