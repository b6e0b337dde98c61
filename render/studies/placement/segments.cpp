#include "render/studies/placement/segments.h"

#include <algorithm>
#include <cmath>

namespace crest {

Segments segments_of(Placement placement, double step, double enter, double exit) {
  const double length = exit - enter;
  switch (placement) {
    case Placement::eye: {
      const double first = (std::floor(enter / step) + 1) * step;
      return {std::max(0, int(std::ceil((exit - first) / step))), first - step / 2, step};
    }
    case Placement::entry:
      return {std::max(0, int(std::ceil(length / step - 0.5))), enter, step};
    case Placement::entry_exit: {
      const int n = int(std::floor(length / step));
      return {n, enter, n > 0 ? length / n : 0};
    }
    case Placement::entry_exit_corner:
      break;
  }
  const int n = std::max(1, int(std::ceil(length / step)));
  return {n, enter, length / n};
}

}  // namespace crest
