#include "app/ray_inspector.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "presets/choices.h"
#include "presets/names.h"
#include "render/raycaster/trace_ray.h"
#include "render/reference/answer.h"

namespace crest {

bool RayInspector::Subject::is(const Scene& other, const Camera& its_camera) const {
  return scene.volume == other.volume && scene.tf == other.tf && scene.rendering == other.rendering &&
         camera == its_camera;
}

bool RayInspector::is_busy() const {
  return wanted_ && (wanted_->tracing || std::ranges::count(wanted_->is_current, false) > 0);
}

void RayInspector::want(const Scene& scene, const Camera& camera, const RayAsk& ask) {
  if (wanted_ && wanted_->inspection.ask == ask && wanted_->subject.is(scene, camera)) return;
  Wanted wanted{{scene, camera}, {ask, {}, {}}, {}, {}};
  if (wanted_ && wanted_->inspection.ask == ask)
    wanted.inspection.modes = std::move(wanted_->inspection.modes);
  wanted_ = std::move(wanted);
}

/// Of the scene in one mode, as its settings have it.
void RayInspector::begin(Renderer& renderer, std::size_t mode) {
  const RayAsk& ask = wanted_->inspection.ask;
  const Camera& camera = wanted_->subject.camera;
  Scene scene = wanted_->subject.scene;
  scene.rendering = in_mode(scene.rendering, view_modes[mode]);
  const ExactRays rays(scene, camera, ask.size, answers_of(scene.rendering).front(), empty_cells_);
  empty_cells_ = rays.empty_cells();
  InspectedRay ray;
  ray.exact = rays.at(ask.pixel);
  PendingTrace steps;
  try {
    steps = begin_trace(renderer.raycaster(), scene, camera, ask.size, ask.pixel);
  } catch (const std::exception& error) {
    ray.why_no_steps = error.what();
  }
  wanted_->tracing.emplace(Wanted::Tracing{mode, std::move(ray), std::move(steps)});
}

void RayInspector::take() {
  auto [mode, ray, steps] = *std::exchange(wanted_->tracing, {});
  try {
    ray.steps = steps.steps();
  } catch (const std::exception& error) {
    ray.why_no_steps = error.what();
  }
  for (TracedStep& step : ray.steps) step.depth += ray.exact.enter;
  ray.crossings = check_crossings(ray.exact, ray.steps);
  wanted_->inspection.modes[mode] = std::move(ray);
}

void RayInspector::work(Renderer& renderer) {
  if (!wanted_) return;
  auto& is_current = wanted_->is_current;
  if (!wanted_->tracing) {
    const auto old = std::ranges::find(is_current, false);
    if (old == is_current.end()) return;
    *old = true;
    const std::size_t mode = std::size_t(old - is_current.begin());
    try {
      begin(renderer, mode);
    } catch (const std::exception& error) {  // it would fail again, and another scene's ray is none of this
      wanted_->inspection.modes[mode].reset();
      wanted_->inspection.errors[mode] = error.what();
      return;
    }
  }
  if (wanted_->tracing->steps.is_over()) take();
}

PickedPixel RayInspector::pick(const Scene& scene, const Camera& camera, const RayAsk& ask) {
  const bool is_same = picking_ && picking_->subject.is(scene, camera) && picking_->last.ask.size == ask.size;
  if (is_same && picking_->last.ask == ask) return picking_->last;
  if (!is_same)
    picking_.reset(
        new Picking{{scene, camera},
                    ExactRays(scene, camera, ask.size, answers_of(scene.rendering).front(), empty_cells_),
                    {}});
  empty_cells_ = picking_->rays.empty_cells();
  picking_->last = {ask, crest::pick(picking_->rays.at(ask.pixel))};
  return picking_->last;
}

std::string ray_table(const RayInspection& inspection) {
  std::string text = "mode,kind,depth,value,surface,opacity,red,green,blue,crossings\n";
  for (std::size_t i = 0; i < view_count; ++i) {
    if (!inspection.modes[i]) continue;
    const InspectedRay& ray = *inspection.modes[i];
    const std::string_view mode = name_of(view_modes[i]);
    int crossings = 0;
    for (const RayPlace& place : ray.exact.places)
      text += fmt::format("{},exact,{},{},{},{},{},{},{},{}\n", mode, place.depth, place.value,
                          place.surface ? fmt::format("{}", *place.surface) : "", place.opacity,
                          place.color.r, place.color.g, place.color.b, crossings += place.surface ? 1 : 0);
    for (const TracedStep& step : ray.steps)
      text +=
          fmt::format("{},drawn,{},{},,{},{},{},{},{}\n", mode, step.depth, ray.exact.value_at(step.depth),
                      step.color.a, step.color.r, step.color.g, step.color.b, step.crossings);
  }
  return text;
}

}  // namespace crest
