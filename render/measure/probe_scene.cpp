#include "render/measure/probe_scene.h"

#include <algorithm>

#include "render/measure/timing.h"

namespace crest {
namespace {

/// A frame is foretold from strips of it, spread over its height, unless it is this short.
constexpr double short_frame_ms = 40;
constexpr int strips = 8, strip_rows = 4;
/// Times of one setting: so many, or fewer where they take this long.
constexpr int most_rounds = 5;
constexpr double enough_ms = 150;

struct Prober {
  Prober(std::shared_ptr<Renderer> r, Scene s, Camera c, glm::ivec2 size)
      : renderer(std::move(r)), scene(std::move(s)), camera(c), full(size, false) {}

  gl::RenderTarget& target_of(glm::ivec2 size) {
    if (size == full.size()) return full;
    if (!sparse || sparse->size() != size) sparse.emplace(size, false);
    return *sparse;
  }
  void draw(const Rendering& rendering, glm::ivec2 size) {
    scene.rendering = rendering;
    renderer->draw(scene, camera, target_of(size));
  }
  void draw_strips(const Rendering& rendering, int count) {
    scene.rendering = rendering;
    const glm::ivec2 size = full.size();
    for (int i = 0; i < count; ++i) {
      const int middle = (2 * i + 1) * size.y / (2 * count);
      const int row = middle - middle % strip_rows;  // where a software renderer's blocks begin
      renderer->draw(scene, camera, full, {{0, row}, {size.x, row + strip_rows}});
    }
  }

  std::shared_ptr<Renderer> renderer;
  Scene scene;
  Camera camera;
  gl::RenderTarget full;
  std::optional<gl::RenderTarget> sparse;
};

SceneProbe::Picture take_picture(Prober& prober, const Rendering& rendering, glm::ivec2 size,
                                 bool with_crossings) {
  prober.draw(rendering, size);
  SceneProbe::Picture picture{prober.target_of(size).read_color(), {}};
  if (!with_crossings) return picture;
  gl::RenderTarget counted(size, true);
  for (const PixelCounts& pixel : prober.renderer->draw_counts(prober.scene, prober.camera, counted))
    picture.crossings.push_back(pixel.crossings);
  return picture;
}

/// Times frames, or strips of them.
struct FrameTimer {
  const Rendering* rendering = nullptr;
  bool is_whole = false;
  double least_ms = std::numeric_limits<double>::infinity();
  double spent_ms = 0;
};

void time_frame(Prober& prober, FrameTimer& timer) {
  const int rows = prober.full.size().y;
  const double ms = finished_ms([&] {
    timer.is_whole ? prober.draw(*timer.rendering, prober.full.size())
                   : prober.draw_strips(*timer.rendering, strips);
  });
  timer.spent_ms += ms;
  timer.least_ms = std::min(timer.least_ms, timer.is_whole ? ms : ms * rows / (strips * strip_rows));
}

FrameTimer make_timer(Prober& prober, const Rendering& rendering) {
  // Layers are drawn picture by picture, and small pictures have no room for strips
  const bool is_whole = rendering.engine == Engine::vdls || prober.full.size().y < 4 * strips * strip_rows;
  FrameTimer timer{&rendering, is_whole};
  finished_ms([&] { prober.draw_strips(rendering, 1); });  // makes what is missing
  time_frame(prober, timer);
  return timer.least_ms < short_frame_ms ? FrameTimer{&rendering, true} : timer;
}

/// The least of some times, turn by turn, so that what else the machine does tells the same of all.
std::vector<double> foretell_frames(Prober& prober, std::span<const Rendering> renderings) {
  std::vector<FrameTimer> timers;
  for (const Rendering& rendering : renderings) timers.push_back(make_timer(prober, rendering));
  for (int round = 0; round < most_rounds; ++round)
    for (FrameTimer& timer : timers)
      if (timer.spent_ms < enough_ms) time_frame(prober, timer);
  std::vector<double> times;
  for (const FrameTimer& timer : timers) times.push_back(timer.least_ms);
  return times;
}

}  // namespace

SceneProbe probe_scene(std::shared_ptr<Renderer> renderer, Scene scene, Camera camera, glm::ivec2 size) {
  const auto prober = std::make_shared<Prober>(std::move(renderer), scene, camera, size);
  SceneProbe probe;
  probe.exact = [=](const ExactAnswer& exact, glm::ivec2 sparse, const Progress& progress) {
    Scene filtered = scene;
    filtered.rendering = with_filters(scene.rendering, exact.filters);
    return render_reference(filtered, camera, sparse, exact.answer, default_tolerance, progress);
  };
  probe.picture = [=](const Rendering& rendering, glm::ivec2 sparse, bool with_crossings) {
    return take_picture(*prober, rendering, sparse, with_crossings);
  };
  probe.sparse_ms = [=](const Rendering& rendering, glm::ivec2 sparse) {
    return finished_ms([&] { prober->draw(rendering, sparse); });
  };
  probe.frame_ms = [=](std::span<const Rendering> renderings) {
    return foretell_frames(*prober, renderings);
  };
  probe.seconds = steady_seconds;
  return probe;
}

}  // namespace crest
