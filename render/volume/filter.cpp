#include "render/volume/filter.h"

#include <algorithm>

namespace crest {
namespace {

FieldFilter filter_of(Filter kind, const Rendering& rendering) {
  return kind == Filter::bc ? FieldFilter{kind, rendering.bc_b, rendering.bc_c} : FieldFilter{kind};
}

/// p(offset + sign * u) as a polynomial of u.
CubicWeight substitute(const CubicWeight& p, double offset, double sign) {
  CubicWeight s = p;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 3; k-- > i;) s[k] += offset * s[k + 1];
  s[1] *= sign;
  s[3] *= sign;
  return s;
}

}  // namespace

FieldFilter dvr_filter(const Rendering& rendering) { return filter_of(rendering.filter, rendering); }

FieldFilter root_filter(const Rendering& rendering) {
  return filter_of(rendering.root_filter.value_or(rendering.filter), rendering);
}

int radius_of(const FieldFilter& filter) {
  return filter.kind == Filter::bspline || filter.kind == Filter::bc ? 2 : 1;
}

int support_radius(const Rendering& rendering) {
  const int dvr = radius_of(dvr_filter(rendering)), root = radius_of(root_filter(rendering));
  if (rendering.mode == Mode::dvr_only) return dvr;
  return rendering.mode == Mode::peak_only ? root : std::max(dvr, root);
}

std::array<CubicWeight, 4> filter_weights(const FieldFilter& filter) {
  if (radius_of(filter) == 1) return {CubicWeight{}, {1, -1, 0, 0}, {0, 1, 0, 0}, {}};
  const double b = filter.kind == Filter::bspline ? 1 : filter.b, c = filter.c;
  const CubicWeight inner{(6 - 2 * b) / 6, 0, (-18 + 12 * b + 6 * c) / 6, (12 - 9 * b - 6 * c) / 6};
  const CubicWeight outer{(8 * b + 24 * c) / 6, (-12 * b - 48 * c) / 6, (6 * b + 30 * c) / 6,
                          (-b - 6 * c) / 6};
  return {substitute(outer, 1, 1), inner, substitute(inner, 1, -1), substitute(outer, 2, -1)};
}

}  // namespace crest
