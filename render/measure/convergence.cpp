#include "render/measure/convergence.h"

#include <algorithm>
#include <cmath>

namespace crest {

std::optional<OrderFit> fit_order(std::span<const double> sizes, std::span<const double> errors, double floor,
                                  int least_points) {
  const auto end = std::ranges::find_if(errors, [&](double error) { return !(error > floor && error > 0); });
  const auto count = std::min(sizes.size(), std::size_t(end - errors.begin()));
  if (count < 2 || int(count) < least_points) return std::nullopt;
  double x_mean = 0, y_mean = 0;
  for (std::size_t i = 0; i < count; ++i) {
    x_mean += std::log(sizes[i]) / double(count);
    y_mean += std::log(errors[i]) / double(count);
  }
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = std::log(sizes[i]) - x_mean;
    xx += x * x;
    xy += x * (std::log(errors[i]) - y_mean);
  }
  if (!(xx > 0)) return std::nullopt;
  return OrderFit{xy / xx, sizes[0], sizes[count - 1], int(count)};
}

}  // namespace crest
