#include "app/exact_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "app/cache_folder.h"
#include "app/picture.h"
#include "app/progress.h"
#include "presets/error.h"
#include "presets/json.h"
#include "presets/names.h"
#include "render/classify/classification.h"
#include "render/notes.h"
#include "render/scene/float_precision.h"

namespace crest {
namespace {

/// Why what the preset sets has no part in an exact answer.
constexpr std::pair<const char*, const char*> without_part[] = {
    {"step", "nothing is sampled: the integral is solved piece by piece"},
    {"placement", "nothing is sampled"},
    {"sampling", "nothing is sampled"},
    {"s_k", "nothing is sampled"},
    {"adaptive", "nothing is sampled"},
    {"skipping", "what is empty is known cell by cell"},
    {"max_peaks", "every crossing is composited"},
    {"peak_bins", "crossings are solved for, not looked up"},
    {"shading", "an exact answer has none"},
    {"gradient", "an exact answer has no shading"},
    {"early_termination", "every ray is solved to its end"},
    {"frames", "an exact answer is rendered once"}};

}  // namespace

std::vector<ExactPicture> render_exact_pictures(const std::vector<Scene>& scenes, const Camera& camera,
                                                glm::ivec2 size, const std::string& output) {
  const Interrupt interrupt;
  ProgressBar bar;
  std::vector<ExactPicture> pictures;
  for (const Scene& scene : scenes) {
    if (const auto blend_mode = scene.rendering.blend_mode; blend_mode != BlendMode::semi_transparent)
      throw Error(
          fmt::format("the exact answer is that of semi_transparent, and rendering.illumination is {}",
                      name_of(blend_mode)));
    const Answer answer = answers_of(scene.rendering).front();
    const std::string doing = fmt::format("exact answer {}", name_of(answer));
    const auto progress = [&](double done) {
      bar.show((double(pictures.size()) + done) / double(scenes.size()), doing);
      return !interrupt.is_requested();
    };
    const auto begin = std::chrono::steady_clock::now();
    try {
      auto [reference, from_cache] = render_reference_cached(
          cache_folder(), default_cache_bytes, scene, camera, size, answer, default_tolerance, progress);
      const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
      auto notes = picture_notes(scene, camera, reference.image());
      pictures.push_back({answer, std::move(reference), taken.count(), from_cache,
                          volume_warnings(*scene.volume), std::move(notes)});
    } catch (const Cancelled&) {
      throw Error(fmt::format("stopped; {} was not written", output));
    }
  }
  return pictures;
}

nlohmann::ordered_json statistics_json(const ExactPicture& picture, const Scene& scene) {
  const Reference& exact = picture.reference;
  const double pixels = double(exact.pixels.size());
  nlohmann::ordered_json json;
  json["mode"] = name_of(scene.rendering.mode);
  json["engine"] = name_of(scene.rendering.engine);
  json["answer"] = name_of(picture.answer);
  json["tolerance"] = default_tolerance;
  json["from_cache"] = picture.from_cache;
  json["frame_ms"] = picture.ms;
  json["crossings_per_ray"] =
      double(std::accumulate(exact.crossings.begin(), exact.crossings.end(), std::uint64_t(0))) / pixels;
  json["grazing_share"] = double(std::ranges::count(exact.grazing, 1)) / pixels;
  json["peaks"] = peaks_json(classify(scene.tf, surface_range(scene)).surfaces);
  for (const auto& [setting, why] : without_part) json["left_out"][setting] = why;
  json["notes"] = picture.notes;
  json["warnings"] = picture.warnings;
  return json;
}

}  // namespace crest
