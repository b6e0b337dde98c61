#include "render/measure/measure_scene.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "render/gl/timer.h"
#include "render/measure/timing.h"
#include "render/reference/cache.h"
#include "render/renderer.h"

namespace crest {
namespace {

constexpr int edits = 5;
/// A draw of so little takes no time beside what an edit brings.
constexpr Tile one_pixel{{0, 0}, {1, 1}};

struct SceneRenderer {
  SceneRenderer(Scene s, Camera c, glm::ivec2 size)
      : scene(std::move(s)), camera(c), target(size, false), counted(size, true) {
    engine.emplace();
  }

  const Scene& scene_with(const Rendering& rendering) {
    scene.rendering = rendering;
    return scene;
  }
  double draw_ms() {
    return finished_ms([&] { engine->draw(scene, camera, target); });
  }
  double draw_pixel_ms() {
    return finished_ms([&] { engine->draw(scene, camera, target, one_pixel); });
  }

  Scene scene;
  Camera camera;
  std::optional<Renderer> engine;
  gl::RenderTarget target, counted;
};

Measurer::Start measure_start(SceneRenderer& renderer, const Rendering& rendering) {
  renderer.scene_with(rendering);
  renderer.engine.reset();  // its room first
  renderer.engine.emplace();
  Measurer::Start start;
  start.first_frame_ms = renderer.draw_ms();

  std::vector<double> added;
  const TransferFunction original = renderer.scene.tf;
  for (int edit = 0; edit < edits; ++edit) {
    auto& color = renderer.scene.tf.points.front().color;
    color.r = (edit + 1) / 997.0;  // none that was there before: nothing held may serve
    const double edited = renderer.draw_pixel_ms();
    added.push_back(edited - renderer.draw_pixel_ms());
  }
  renderer.scene.tf = original;
  start.edit_ms = std::max(0.0, median(added));
  return start;
}

Measurer::Picture take_picture(SceneRenderer& renderer, const Rendering& rendering) {
  Measurer::Picture picture;
  const Scene& scene = renderer.scene_with(rendering);
  renderer.engine->draw(scene, renderer.camera, renderer.target);
  picture.image = renderer.target.read_color();
  const auto pixels = renderer.engine->draw_counts(scene, renderer.camera, renderer.counted);
  const RenderCounts counts = sum_of(pixels);
  picture.samples_per_ray = counts.samples / counts.pixels;
  picture.dvr_samples_per_ray = counts.dvr_samples / counts.pixels;
  picture.crossings_per_ray = counts.crossings / counts.pixels;
  picture.crossings_left_out_per_ray = counts.crossings_left_out / counts.pixels;
  for (const PixelCounts& pixel : pixels) picture.crossings.push_back(pixel.crossings);
  return picture;
}

Measurer::FrameTime time_frame(SceneRenderer& renderer, const Rendering& rendering) {
  renderer.scene_with(rendering);
  Measurer::FrameTime time;
  time.wall_ms = finished_ms([&] {
    time.device_ms =
        gl::device_ms([&] { renderer.engine->draw(renderer.scene, renderer.camera, renderer.target); });
  });
  return time;
}

}  // namespace

Measurer measure_scene(Scene scene, Camera camera, glm::ivec2 size, std::filesystem::path cache) {
  const auto renderer = std::make_shared<SceneRenderer>(scene, camera, size);
  Measurer measurer;
  measurer.reference = [=](const ExactAnswer& exact, const Progress& progress) {
    Scene filtered = scene;
    filtered.rendering = with_filters(scene.rendering, exact.filters);
    return render_reference_cached(cache, default_cache_bytes, filtered, camera, size, exact.answer,
                                   default_tolerance, progress)
        .reference;
  };
  measurer.start = [=](const Rendering& rendering) { return measure_start(*renderer, rendering); };
  measurer.picture = [=](const Rendering& rendering) { return take_picture(*renderer, rendering); };
  measurer.frame = [=](const Rendering& rendering) { return time_frame(*renderer, rendering); };
  measurer.seconds = steady_seconds;
  return measurer;
}

}  // namespace crest
