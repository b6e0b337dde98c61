#include "presets/exchange/flat_points.h"

#include "presets/json.h"

namespace crest {

Json flat_colors(const TransferFunction& tf, const std::vector<double>& values) {
  Json flat = Json::array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const glm::dvec3& color = tf.points[i].color;
    for (const double n : {values[i], color.r, color.g, color.b}) flat.push_back(n);
  }
  return flat;
}

Json flat_opacities(const TransferFunction& tf, const std::vector<double>& values,
                    const std::vector<double>& shape) {
  Json flat = Json::array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    flat.push_back(values[i]);
    flat.push_back(tf.points[i].opacity);
    for (const double n : shape) flat.push_back(n);
  }
  return flat;
}

}  // namespace crest
