#include "render/volume/whole_values.h"

#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

namespace crest {
namespace {

bool is_power_of_two(double x) {
  int exponent = 0;
  return std::isfinite(x) && std::frexp(x, &exponent) == 0.5;
}

}  // namespace

std::optional<WholeValues> whole_values(const Volume& volume) {
  constexpr double float_integers = 1 << 24, most = std::numeric_limits<std::uint16_t>::max();
  const auto [slope, intercept] = volume.values.map();
  const double step = std::abs(slope);
  if (volume.values.are_floats() || volume.has_empty_cells() || !is_power_of_two(step)) return std::nullopt;
  const double added = intercept / step;  // with what is stored, still a whole number that a float has
  if (added != std::round(added) || !(std::abs(added) < float_integers - most)) return std::nullopt;
  // The range may be that of more than these values: from the step at its least value or below
  const ValueRange range = volume.statistics.range;
  const double first = std::floor((range.min - intercept) / step),
               last = std::ceil((range.max - intercept) / step);
  if (last - first > most || !(std::abs(first + added) < float_integers - most)) return std::nullopt;
  return WholeValues{intercept + first * step, step, int(last - first)};
}

void write_steps(const Volume& volume, const WholeValues& whole, std::size_t first, int scale,
                 std::span<std::uint16_t> out) {
  const auto [slope, intercept] = volume.values.map();
  const int least = int((whole.base - intercept) / slope), sign = slope < 0 ? -scale : scale;
  std::visit(
      [&](const auto& stored) {
        if constexpr (std::is_integral_v<typename std::decay_t<decltype(stored)>::value_type>) {
          for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = std::uint16_t((int(stored[first + i]) - least) * sign);
        }
      },
      volume.values.stored());
}

}  // namespace crest
