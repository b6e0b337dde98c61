#include <algorithm>
#include <cmath>

#include "ui/studio.h"

namespace crest {
namespace {

constexpr std::array<std::uint8_t, 4> no_peak{26, 28, 33, 255};

std::array<std::uint8_t, 4> bytes_of(glm::dvec3 color) {
  const auto byte = [](double v) { return std::uint8_t(std::lround(255 * std::clamp(v, 0.0, 1.0))); };
  return {byte(color.r), byte(color.g), byte(color.b), 255};
}

}  // namespace

Picture8 table_picture(const PeakTable& table, std::span<const Peak> shown) {
  Picture8 picture{table.bins, table.bins, {}};
  picture.rgba.reserve(4 * table.cells.size());
  for (int exit = table.bins - 1; exit >= 0; --exit)
    for (int entry = 0; entry < table.bins; ++entry) {
      const int first = peaks_met(table, entry, exit)[0];
      const bool known = first >= 0 && std::size_t(first) < shown.size();
      const auto color = known ? bytes_of(shown[std::size_t(first)].color) : no_peak;
      picture.rgba.insert(picture.rgba.end(), color.begin(), color.end());
    }
  return picture;
}

}  // namespace crest
