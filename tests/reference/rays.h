#pragma once

#include <glm/geometric.hpp>
#include <memory>

#include "render/reference/reference.h"
#include "tests/classify/tf_of.h"

namespace crest::testing {

/// A volume of the values of `field(i, j, k)` at its points.
template <class Field>
std::shared_ptr<const Volume> volume_of(glm::ivec3 dims, Field&& field, glm::dvec3 spacing = glm::dvec3(1),
                                        glm::dvec3 origin = glm::dvec3(0)) {
  auto volume = std::make_shared<Volume>();
  volume->grid = {.dims = dims, .spacing = spacing, .origin = origin};
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) volume->values.floats().push_back(float(field(i, j, k)));
  volume->statistics = compute_statistics(volume->grid, volume->values);
  return volume;
}

/// A volume whose values change along x alone.
inline std::shared_ptr<const Volume> profile(const std::vector<float>& values) {
  return volume_of({int(values.size()), 2, 2}, [&](int i, int, int) { return values[std::size_t(i)]; });
}

inline Scene scene_of(std::shared_ptr<const Volume> volume, TransferFunction tf) {
  return {.volume = std::move(volume), .tf = std::move(tf), .rendering = {}};
}

/// A picture of one pixel, whose ray goes from `eye` towards `target`.
inline Camera one_ray(glm::dvec3 eye, glm::dvec3 target) {
  return {.eye = eye, .target = target, .up = {0, 0, 1}, .fov_y_degrees = 30, .unknown = {}};
}

struct OneRay {
  glm::dvec4 color;
  int crossings;
  bool grazing;
};

inline OneRay along(const Scene& scene, glm::dvec3 eye, glm::dvec3 target, Answer answer,
                    double tolerance = 1e-10) {
  const Reference picture = render_reference(scene, one_ray(eye, target), {1, 1}, answer, tolerance);
  return {picture.pixels[0], int(picture.crossings[0]), picture.grazing[0] != 0};
}

/// The same TF with every point of one colour, or each of its own.
inline TransferFunction colored(TransferFunction tf, const std::vector<glm::dvec3>& colors) {
  for (std::size_t i = 0; i < tf.points.size(); ++i) tf.points[i].color = colors[i % colors.size()];
  return tf;
}

}  // namespace crest::testing
