#include "render/scene/error_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>

namespace crest {
namespace {

constexpr glm::vec3 color_of(std::uint32_t rgb) {
  return {float(rgb >> 16) / 255, float(rgb >> 8 & 255) / 255, float(rgb & 255) / 255};
}

constexpr std::array scale{color_of(0x000004), color_of(0x210c4a), color_of(0x57106e),
                           color_of(0x8a226a), color_of(0xbc3754), color_of(0xe45a31),
                           color_of(0xf98e09), color_of(0xf9cb35), color_of(0xfcffa4)};

}  // namespace

std::span<const glm::vec3> error_scale() { return scale; }

glm::vec3 error_color(double error) {
  const double decades = std::log10(most_shown_error / least_shown_error);
  const double height = error > 0 ? 1 + std::log10(error / most_shown_error) / decades : 0;
  const double place = std::clamp(height, 0.0, 1.0) * (scale.size() - 1);
  const auto below = std::min(std::size_t(place), scale.size() - 2);
  return glm::mix(scale[below], scale[below + 1], float(place - double(below)));
}

}  // namespace crest
