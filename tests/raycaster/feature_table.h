#pragma once

#include "render/shader_inputs/features.h"
#include "tests/pairwise.h"

namespace crest::testing {

/// The ray caster's features with the values that each may take, and the rules of which go together: those of
/// find_need (render/raycaster/need.h), which never asks for anything else where something is sampled.
Pairwise<Features> feature_table();

/// The same of those that solve rays from cell to cell.
Pairwise<Features> analytic_feature_table();

}  // namespace crest::testing
