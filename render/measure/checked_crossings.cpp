#include "render/measure/checked_crossings.h"

#include <algorithm>
#include <limits>

namespace crest {
namespace {

constexpr double opaque = 0.999;  ///< what lies behind is seen by nobody, and may be left out

/// From which depth on the ray is opaque.
double opaque_depth(const ExactRay& ray) {
  const auto first = std::ranges::find_if(ray.places, [](const RayPlace& p) { return p.opacity >= opaque; });
  return first == ray.places.end() ? std::numeric_limits<double>::infinity() : first->depth;
}

}  // namespace

int CheckedCrossings::missed() const {
  return int(std::ranges::count(exact, false, &CheckedCrossing::found));
}

CheckedCrossings check_crossings(const ExactRay& exact, std::span<const TracedStep> steps) {
  CheckedCrossings result;
  const double last = opaque_depth(exact);
  for (const RayPlace& place : exact.places)
    if (place.surface && place.depth <= last) result.exact.push_back({place.depth, *place.surface, false});
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const double begin = steps[i - 1].depth, end = steps[i].depth, slack = 1e-3 * (end - begin);
    std::uint32_t found = steps[i].crossings - steps[i - 1].crossings;
    for (CheckedCrossing& crossing : result.exact) {
      if (found == 0 || crossing.depth > end + slack) break;
      if (crossing.found || crossing.depth < begin - slack) continue;
      crossing.found = true;
      --found;
    }
    if (end <= last) result.invented += int(found);
  }
  return result;
}

}  // namespace crest
