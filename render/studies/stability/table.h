#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "render/studies/stability/lab.h"

namespace crest::stability {

/// A stiff or extreme situation, and what makes its rows.
struct Case {
  std::string_view group, name;
  std::vector<Row> (*rows)(Lab& lab);
};

/// The cases' cameras are for square pictures of at least so many pixels a side.
inline constexpr int least_side = 16;

/// All cases, group by group.
std::span<const Case> all_cases();

/// The rows of these cases; `progress` is told each before it begins. A case that throws becomes a row that
/// fails, with the error as its quantity. Throws Cancelled when the lab's stop is asked for.
std::vector<Row> run(Lab& lab, std::span<const Case> cases,
                     const std::function<void(const Case&)>& progress = {});

}  // namespace crest::stability
