#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "render/gl/pending_read.h"
#include "render/raycaster/raycaster.h"
#include "render/scene/traced_step.h"

namespace crest {

/// Longer rays are not traced.
inline constexpr int most_traced_steps = 8192;

/// A traced ray that the device may not be through with.
class PendingTrace {
 public:
  PendingTrace() = default;  ///< of a ray that misses the box
  PendingTrace(const gl::RenderTarget& drawn, double unit);
  bool is_over() const;                   ///< does not wait
  std::vector<TracedStep> steps() const;  ///< waits

 private:
  struct Reads {
    gl::PendingRead colors, counts;
  };
  std::optional<Reads> reads_;
  double unit_ = 1;
};

/// What the ray caster draws of one pixel of a picture, interval by interval: from the entry (nothing yet) to
/// the exit. Depths are from the entry. It is the shader's own march, drawn as often as there are intervals,
/// each time a bit further. Skipping is left out, since it changes no sample. Empty where the ray misses the
/// box. Throws Error where the ray is too long, as draw(), and for the exact march, which has no samples.
PendingTrace begin_trace(Raycaster& raycaster, Scene scene, const Camera& camera, glm::ivec2 size,
                         glm::ivec2 pixel);
/// The same, and waits for it.
std::vector<TracedStep> trace_ray(Raycaster& raycaster, Scene scene, const Camera& camera, glm::ivec2 size,
                                  glm::ivec2 pixel);

}  // namespace crest
