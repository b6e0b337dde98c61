#include "render/raycaster/sharpness.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace crest {
namespace {

/// What a segment of this material adds: premultiplied colour and opacity.
glm::dvec4 added(const Classified& material, double unit_distance, double length) {
  const double opacity = -std::expm1(-extinction(material.opacity, unit_distance) * length);
  return {opacity * material.color, opacity};
}

double largest_channel(const glm::dvec4& a, const glm::dvec4& b) {
  const glm::dvec4 d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z, d.w});
}

}  // namespace

// Between points it rises or falls, so that the two places which differ most are both points, or one is a
// point and the other as far away as may be.
double largest_change_within(const TransferFunction& tf, ValueRange field, double off, double length) {
  struct Place {
    double value;
    glm::dvec4 added;
  };
  const auto added_at = [&](const Classified& material) { return added(material, tf.unit_distance, length); };
  std::vector<Place> places{{field.min, added_at(evaluate(tf, field.min))}};
  for (const ControlPoint& point : tf.points)
    if (point.value > field.min && point.value < field.max)
      places.push_back({point.value, added_at({point.color, point.opacity})});
  places.push_back({field.max, added_at(evaluate(tf, field.max))});

  double most = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto compare = [&](const glm::dvec4& other) {
      most = std::max(most, largest_channel(places[i].added, other));
    };
    for (const double value : {places[i].value - off, places[i].value + off})
      compare(added_at(evaluate(tf, std::clamp(value, field.min, field.max))));
    for (std::size_t j = i + 1; j < places.size() && places[j].value <= places[i].value + off; ++j)
      compare(places[j].added);
  }
  return most;
}

}  // namespace crest
