#include "render/studies/random/measure.h"

#include <fmt/core.h>

#include <cmath>
#include <map>

#include "render/reference/cache.h"

namespace crest {
namespace {

void throw_if_stopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Cancelled();
}

/// A picture, and what each pixel composited; nothing where the mode shows no surfaces.
struct Drawn {
  Image image;
  std::vector<std::uint32_t> crossings;
};

/// The scene that is drawn, and its exact answers, each when it is first asked for.
struct Subject {
  Renderer& renderer;
  const RandomScene& random;
  const RandomStudySettings& settings;
  gl::RenderTarget target{settings.size, false}, counted{settings.size, true};
  std::map<ExactAnswer, Reference> references = {};

  Drawn draw(const Rendering& rendering) {
    throw_if_stopped(settings.stop);
    Scene scene = random.scene;
    scene.rendering = rendering;
    if (!shows_surfaces(rendering.mode)) {
      renderer.draw(scene, random.camera, target);
      return {target.read_color(), {}};
    }
    Drawn drawn;
    for (const PixelCounts& counts : renderer.draw_counts(scene, random.camera, counted))
      drawn.crossings.push_back(counts.crossings);
    drawn.image = counted.read_color();
    return drawn;
  }

  const Reference& exact(const ExactAnswer& answer) {
    if (const auto found = references.find(answer); found != references.end()) return found->second;
    Scene scene = random.scene;
    scene.rendering = with_filters(scene.rendering, answer.filters);
    auto cached = render_reference_cached(settings.cache, default_cache_bytes, scene, random.camera,
                                          settings.size, answer.answer, default_tolerance,
                                          [&](double) { return !settings.stop.stop_requested(); });
    return references.emplace(answer, std::move(cached.reference)).first->second;
  }
};

void measure_method(RandomSceneStudy& study, Subject& subject, const Method& method, double step, int index) {
  const Rendering rendering = measured_rendering(method, step, subject.random.scene.rendering);
  const Drawn drawn = subject.draw(rendering);
  for (const ExactAnswer& answer : exact_answers_of(rendering)) {
    RandomMeasurement m = compare_random(subject.exact(answer), drawn.image, drawn.crossings);
    m.scene = index;
    m.method = method.id;
    m.step = method.has_step ? step : 0;
    m.answer = answer;
    study.measurements.push_back(std::move(m));
  }
}

}  // namespace

RandomMeasurement compare_random(const Reference& exact, const Image& image,
                                 std::span<const std::uint32_t> crossings) {
  RandomMeasurement m;
  m.error = image_error(exact, image, crossings, std::nullopt);
  m.wrong = std::size_t(std::lround(m.error.compared.share * double(m.error.compared.pixels)));
  const std::vector<float> differences = pixel_differences(exact.image(), image);
  float largest = 0;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (exact.grazing[i]) continue;
    m.outliers += differences[i] > outlier_difference;
    if (differences[i] <= largest) continue;
    largest = differences[i];
    m.worst = {int(i) % image.size.x, int(i) / image.size.x};
  }
  return m;
}

RandomSceneStudy study_random_scene(Renderer& renderer, const RandomScene& random, int index,
                                    const RandomStudySettings& settings, std::span<const Method> methods) {
  RandomSceneStudy study;
  Subject subject{renderer, random, settings};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Method& method = methods[i];
    if (const std::string why = why_left_out(method, random.scene); !why.empty()) {
      study.left_out.push_back({std::string(method.id), why});
      continue;
    }
    settings.progress(method.id, double(i) / double(methods.size()));
    for (const double step : random_study_steps) {
      measure_method(study, subject, method, step, index);
      if (!method.has_step) break;
    }
  }
  const auto& references = subject.references;
  for (const Answer answer : {Answer::integral, Answer::integral_and_crossings})
    if (const auto found = references.find(answer); found != references.end())
      study.exact = found->second.image();
  return study;
}

}  // namespace crest
