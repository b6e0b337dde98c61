#include "render/stability/lab.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace crest::stability {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Pixels>
double largest(const Image& a, const Pixels& b, auto&& difference) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 4; ++channel) {
      const double d = difference(double(a.pixels[i][channel]), double(b[i][channel]));
      largest = std::max(largest, std::isnan(d) ? infinity : d);
    }
  return largest;
}

double absolute(double a, double b) { return std::abs(a - b); }

}  // namespace

Image Lab::draw(const Scene& scene, const Camera& camera, glm::ivec2 pixels) const {
  gl::RenderTarget target(pixels, false);
  raycaster.draw(scene, camera, target);
  return target.read_color();
}

CountedPicture draw_counted(const Lab& lab, const Scene& scene, const Camera& camera, glm::ivec2 pixels) {
  gl::RenderTarget target(pixels, true);
  CountedPicture picture;
  for (const PixelCounts& counts : lab.raycaster.draw_counts(scene, camera, target))
    picture.crossings.push_back(counts.crossings);
  picture.image = target.read_color();
  return picture;
}

double largest_difference(const Image& a, const Image& b) { return largest(a, b.pixels, absolute); }

double largest_difference(const Image& a, const std::vector<glm::dvec4>& truth) {
  return largest(a, truth, absolute);
}

double largest_relative_difference(const Image& a, const std::vector<glm::dvec4>& truth, double floor) {
  return largest(a, truth,
                 [&](double x, double y) { return std::abs(x - y) / std::max(std::abs(y), floor); });
}

int unequal_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    count += std::memcmp(&a.pixels[i], &b.pixels[i], sizeof(glm::vec4)) != 0;
  return count;
}

}  // namespace crest::stability
