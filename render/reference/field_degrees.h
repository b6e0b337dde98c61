#pragma once

namespace crest::reference {

/// Degrees of the polynomials that the field along a ray is: in a cell of a trilinear field exactly; of a
/// formula to a tolerance, in pieces as short as that takes.
inline constexpr int cell_degree = 3, formula_degree = 8;

}  // namespace crest::reference
