#include "render/raycaster/trace_ray.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

#include "presets/choices.h"
#include "presets/error.h"
#include "render/gl/fullscreen.h"
#include "render/gl/uniforms.h"
#include "render/raycaster/bindings.h"
#include "render/resources/classification.h"
#include "render/shader_inputs/blend_mode.h"
#include "render/shader_inputs/view_uniforms.h"

namespace crest {
namespace {

constexpr int most_columns = 1024;

void draw_traces(Resources& resources, const Scene& scene, const Camera& camera, glm::ivec2 size,
                 glm::ivec2 pixel, const Need& need, const gl::RenderTarget& target) {
  using gl::set;
  std::vector<std::string> defines = shader_defines(need.features);
  defines.push_back("TRACE");
  const GLuint id = resources.programs.program("fullscreen.vert", fragment_shader(need.features), defines);
  bind_scene(resources, scene, classification_of(resources.held, scene), need, id);
  set_view(id, scene, camera, size);
  set(id, "traced_pixel", glm::vec2(pixel) + 0.5F);
  set(id, "trace_width", target.size().x);
  gl::begin_whole_target(target.framebuffer(), target.size());
  gl::FullscreenTriangle().draw(id);
}

}  // namespace

PendingTrace::PendingTrace(const gl::RenderTarget& drawn, double unit)
    : reads_(Reads{{drawn, gl::PendingRead::What::color}, {drawn, gl::PendingRead::What::counts}}),
      unit_(unit) {}

bool PendingTrace::is_over() const {
  return !reads_ || (reads_->colors.is_over() && reads_->counts.is_over());
}

std::vector<TracedStep> PendingTrace::steps() const {
  if (!reads_) return {};
  const std::vector<glm::vec4> colors = reads_->colors.color();
  const std::vector<glm::uvec4> counts = reads_->counts.counts();
  std::vector<TracedStep> steps;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double depth = unit_ * double(std::bit_cast<float>(counts[i].w));
    if (i > 0 && !(depth > steps.back().depth)) break;  // the ray has ended
    steps.push_back({depth, colors[i], counts[i].z});
  }
  return steps.size() > 1 ? steps : std::vector<TracedStep>();
}

PendingTrace begin_trace(Raycaster& raycaster, Scene scene, const Camera& camera, glm::ivec2 size,
                         glm::ivec2 pixel) {
  if (is_analytic(scene.rendering.classification)) throw Error("the exact march takes no samples");
  scene.rendering.engine = Engine::raycaster;
  const bool skips = raycaster.need(scene, camera, size, true).needed.skipping;
  scene.rendering.skipping = false;
  Need need = raycaster.need(scene, camera, size, true);
  if (need.is_empty()) return {};
  need.needed.skipping = skips;  // which bricks there are: those that the picture is drawn from
  if (need.intervals > most_traced_steps)
    throw Error(fmt::format("up to {} steps along a ray are too many to be told one by one (at most {})",
                            need.intervals, most_traced_steps));
  need.features.long_rays = true;
  const int columns = std::min(need.intervals + 1, most_columns), rows = need.intervals / columns + 1;
  const gl::RenderTarget target({columns, rows}, true);
  draw_traces(raycaster.resources(), scene, camera, size, pixel, need, target);
  return {target, scene.volume->grid.smallest_spacing()};
}

std::vector<TracedStep> trace_ray(Raycaster& raycaster, Scene scene, const Camera& camera, glm::ivec2 size,
                                  glm::ivec2 pixel) {
  return begin_trace(raycaster, std::move(scene), camera, size, pixel).steps();
}

}  // namespace crest
