#include "render/studies/stability/lab.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "render/reference/reference.h"

namespace crest::stability {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Pixels>
double largest(const Image& a, const Pixels& b, auto&& difference, const std::vector<bool>& left_out = {}) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (!left_out.empty() && left_out[i]) continue;
    for (int channel = 0; channel < 4; ++channel) {
      const double d = difference(double(a.pixels[i][channel]), double(b[i][channel]));
      largest = std::max(largest, std::isnan(d) ? infinity : d);
    }
  }
  return largest;
}

void throw_if_stopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Cancelled();
}

double absolute(double a, double b) { return std::abs(a - b); }

}  // namespace

Image Lab::draw(const Scene& scene, const Camera& camera, glm::ivec2 pixels) const {
  throw_if_stopped(stop);
  gl::RenderTarget target(pixels, false);
  raycaster.draw(scene, camera, target);
  return target.read_color();
}

CountedPicture draw_counted(const Lab& lab, const Scene& scene, const Camera& camera, glm::ivec2 pixels) {
  throw_if_stopped(lab.stop);
  gl::RenderTarget target(pixels, true);
  CountedPicture picture;
  for (const PixelCounts& counts : lab.raycaster.draw_counts(scene, camera, target)) {
    picture.crossings.push_back(counts.crossings);
    picture.dvr_samples.push_back(counts.dvr_samples);
  }
  picture.image = target.read_color();
  return picture;
}

Deviation deviation_from_exact(const CountedPicture& picture, const Scene& scene, const Camera& camera,
                               const std::vector<bool>& left_out) {
  const Reference exact =
      render_reference(scene, camera, picture.image.size, answers_of(scene.rendering).front());
  Deviation deviation;
  for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
    if (exact.grazing[i] || (!left_out.empty() && left_out[i])) {
      ++deviation.left_out;
      continue;
    }
    for (int channel = 0; channel < 4; ++channel) {
      const double d = std::abs(double(picture.image.pixels[i][channel]) - exact.pixels[i][channel]);
      deviation.largest = std::max(deviation.largest, std::isnan(d) ? infinity : d);
    }
    const int missed = int(exact.crossings[i]) - int(picture.crossings[i]);
    deviation.missed += std::max(missed, 0);
    deviation.miscounted += missed < 0 || missed % 2 != 0;
  }
  return deviation;
}

double largest_difference(const Image& a, const Image& b, const std::vector<bool>& left_out) {
  return largest(a, b.pixels, absolute, left_out);
}

double largest_difference(const Image& a, const std::vector<glm::dvec4>& truth,
                          const std::vector<bool>& left_out) {
  return largest(a, truth, absolute, left_out);
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
