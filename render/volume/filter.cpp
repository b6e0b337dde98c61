#include "render/volume/filter.h"
#include "presets/choices.h"

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

/// Of the family of Mitchell and Netravali.
std::array<CubicWeight, 4> cubic_weights(double b, double c) {
  const CubicWeight inner{(6 - 2 * b) / 6, 0, (-18 + 12 * b + 6 * c) / 6, (12 - 9 * b - 6 * c) / 6};
  const CubicWeight outer{(8 * b + 24 * c) / 6, (-12 * b - 48 * c) / 6, (6 * b + 30 * c) / 6,
                          (-b - 6 * c) / 6};
  return {substitute(outer, 1, 1), inner, substitute(inner, 1, -1), substitute(outer, 2, -1)};
}

}  // namespace

FieldFilter dvr_filter(const Rendering& rendering) { return filter_of(rendering.filter, rendering); }

FieldFilter root_filter(const Rendering& rendering) {
  return filter_of(rendering.root_filter.value_or(rendering.filter), rendering);
}

int radius_of(const FieldFilter& filter) {
  switch (filter.kind) {
    case Filter::linear:
    case Filter::linear_exact:
      return 1;
    case Filter::bspline:
    case Filter::bc:
      break;
  }
  return 2;
}

int support_radius(const Rendering& rendering) {
  const int dvr = radius_of(dvr_filter(rendering)), root = radius_of(root_filter(rendering));
  return std::max(shows_dvr(rendering.mode) ? dvr : 1, shows_surfaces(rendering.mode) ? root : 1);
}

std::array<CubicWeight, 4> filter_weights(const FieldFilter& filter) {
  switch (filter.kind) {
    case Filter::linear:
    case Filter::linear_exact:
      return {CubicWeight{}, {1, -1, 0, 0}, {0, 1, 0, 0}, {}};
    case Filter::bspline:
      return cubic_weights(1, 0);
    case Filter::bc:
      break;
  }
  return cubic_weights(filter.b, filter.c);
}

}  // namespace crest
