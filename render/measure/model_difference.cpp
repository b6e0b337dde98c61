#include "render/measure/model_difference.h"

namespace crest {

ExactAnswer own_integral(const Rendering& scene) {
  return {Answer::integral, filters_of(Answer::integral, scene)};
}

std::optional<ImageError> model_difference(const std::map<ExactAnswer, Reference>& exact,
                                           const ExactAnswer& answer, const Rendering& scene) {
  const auto integral = exact.find(own_integral(scene)), other = exact.find(answer);
  if (integral == other || integral == exact.end() || other == exact.end()) return std::nullopt;
  return image_error(integral->second, other->second.image(), {}, glm::vec3(scene.background));
}

}  // namespace crest
