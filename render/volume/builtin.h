#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "render/volume/memory.h"
#include "render/volume/volume.h"

namespace crest {

/// A scalar field known by its formula, over the cube [-1, 1]^3.
struct FormulaField {
  std::function<double(glm::dvec3)> value;
  std::function<glm::dvec3(glm::dvec3)> gradient;
};

/// A built-in volume: its name, and its parameters with their defaults ("n=128 seed=1").
struct Builtin {
  std::string_view name, summary, parameters;
};
std::vector<Builtin> builtins();

/// The field of "NAME?key=value&..." (without "builtin:"). Throws Error for a name or key that is not known.
FormulaField builtin_field(std::string_view name_and_query);

/// The same field on a grid of n points an axis (?n=...; without it the built-in's own number) over the cube,
/// spacing 2/(n-1), origin -1. Throws Error when it takes more than `memory` bytes.
Volume make_builtin(std::string_view name_and_query, std::uint64_t memory = available_memory());

}  // namespace crest
