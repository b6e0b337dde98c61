#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "render/stability/lab.h"

namespace crest::stability {

/// A stiff or extreme situation, and what makes its rows.
struct Case {
  std::string_view group, name;
  std::vector<Row> (*rows)(Lab& lab);
};

/// All cases, group by group.
std::span<const Case> all_cases();

/// Runs all cases; `progress` is told each before it begins. A case that throws becomes a row that fails,
/// with the error as its quantity.
std::vector<Row> run_all(Lab& lab, const std::function<void(const Case&)>& progress = {});

}  // namespace crest::stability
