#include "render/studies/knoll/lab.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/choices.h"
#include "presets/names.h"
#include "render/measure/timing.h"
#include "render/reference/cache.h"

namespace crest {
namespace {

constexpr double seconds_to_time = 4;
constexpr int fewest_rounds = 3, most_rounds = 9;

/// What an exact answer of a scene depends on, beyond the scene.
std::string answer_key(const Rendering& r, double peak_gain) {
  return fmt::format("{} {} {} {} {} {}", name_of(answer_of(r)), name_of(r.filter),
                     r.root_filter ? name_of(*r.root_filter) : "", r.bc_b, r.bc_c, peak_gain);
}

}  // namespace

Answer answer_of(const Rendering& rendering) { return answers_of(rendering).back(); }

const Shot* ShotGroup::find(std::string_view variant) const {
  const auto found = std::ranges::find_if(shots, [&](const Shot& s) { return s.variant.id == variant; });
  return found == shots.end() ? nullptr : &*found;
}

KnollLab::KnollLab(Settings settings)
    : settings_(std::move(settings)), target_(settings_.size, false), counted_(settings_.size, true) {}

void KnollLab::throw_if_stopped() const {
  if (settings_.stop.stop_requested()) throw Cancelled();
}

Image KnollLab::draw(const Scene& scene, const Camera& camera) {
  raycaster_.draw(scene, camera, target_);
  return target_.read_color();
}

const Reference& KnollLab::exact(const KnollScene& scene, const Variant& variant) {
  if (exact_scene_ != scene.id) exact_.clear();
  exact_scene_ = scene.id;
  const Scene measured = measured_scene(scene, variant);
  const std::string key = answer_key(measured.rendering, variant.peak_gain);
  if (const auto found = exact_.find(key); found != exact_.end()) return found->second;
  const auto go_on = [&](double) { return !settings_.stop.stop_requested(); };
  CachedReference reference =
      render_reference_cached(settings_.cache_folder, default_cache_bytes, measured, scene.camera,
                              settings_.size, answer_of(measured.rendering), default_tolerance, go_on);
  return exact_.emplace(key, std::move(reference.reference)).first->second;
}

Shot KnollLab::shoot(const KnollScene& scene, const Variant& variant, bool with_pictures) {
  throw_if_stopped();
  Scene measured = measured_scene(scene, variant);
  const Reference& wanted = exact(scene, variant);
  Shot shot;
  shot.variant = variant;
  shot.rendering = measured.rendering;
  const Image image = draw(measured, scene.camera);
  const auto pixels = raycaster_.draw_counts(measured, scene.camera, counted_);
  const RenderCounts counts = sum_of(pixels);
  shot.samples_per_ray = counts.samples / counts.pixels;
  shot.dvr_samples_per_ray = counts.dvr_samples / counts.pixels;
  shot.crossings_per_ray = counts.crossings / counts.pixels;
  const Need need = raycaster_.need(measured, scene.camera, settings_.size, false);
  shot.skips = need.features.skipping;
  shot.peak_bins = need.features.peak_table ? need.peak_bins : 0;
  std::vector<std::uint32_t> crossings;
  for (const PixelCounts& pixel : pixels) crossings.push_back(pixel.crossings);
  if (!shows_surfaces(measured.rendering.mode)) crossings.clear();
  shot.answer = answer_of(measured.rendering);
  shot.error = image_error(wanted, image, crossings, measured.rendering.background);
  if (!with_pictures) return shot;
  shot.error_picture = settings_.paint_error(wanted, image);
  measured.rendering.shading = Shading::gradient;
  shot.picture = draw(measured, scene.camera);
  return shot;
}

void KnollLab::time(const KnollScene& scene, std::vector<Shot>& shots) {
  std::vector<Scene> scenes;
  double first_ms = 0;
  for (Shot& shot : shots) {
    shot.frame_ms.clear();
    scenes.push_back(measured_scene(scene, shot.variant));
    raycaster_.draw(scenes.back(), scene.camera, target_);  // uploads and compiles, too
    first_ms += finished_ms([&] { raycaster_.draw(scenes.back(), scene.camera, target_); });
  }
  const int rounds =
      int(std::clamp(1000 * seconds_to_time / first_ms, double(fewest_rounds), double(most_rounds)));
  for (int round = 0; round < rounds; ++round)
    for (std::size_t turn = 0; turn < shots.size(); ++turn) {
      throw_if_stopped();
      const std::size_t i = (turn + std::size_t(round)) % shots.size();
      shots[i].frame_ms.push_back(finished_ms([&] { raycaster_.draw(scenes[i], scene.camera, target_); }));
    }
  for (Shot& shot : shots) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < shot.frame_ms.size(); ++i)
      ratios.push_back(shot.frame_ms[i] / shots.front().frame_ms[i]);
    shot.median_ms = median(shot.frame_ms);
    shot.ratio = median(ratios);
  }
}

ShotGroup KnollLab::shoot_group(std::string id, std::string title, const KnollScene& scene,
                                std::span<const Variant> variants,
                                const std::function<bool(const Variant&)>& is_pictured) {
  ShotGroup group{std::move(id), std::move(title), scene.id, {}};
  for (const Variant& variant : variants) {
    Shot& shot = group.shots.emplace_back(shoot(scene, variant, is_pictured(variant)));
    if (group.shots.front().answer != Answer::integral || shot.answer == Answer::integral) continue;
    const Image shown = exact(scene, variant).image();
    const auto background = glm::vec3(scene.scene.rendering.background);
    shot.model_difference = image_error(exact(scene, variants.front()), shown, {}, background).compared.rmse;
  }
  time(scene, group.shots);
  return group;
}

double KnollLab::rmse(const KnollScene& scene, const Variant& variant) {
  throw_if_stopped();
  const Scene measured = measured_scene(scene, variant);
  const Reference& wanted = exact(scene, variant);
  const Image image = draw(measured, scene.camera);
  return image_error(wanted, image, {}, measured.rendering.background).compared.rmse;
}

RenderCounts KnollLab::counts(const KnollScene& scene, const Variant& variant) {
  throw_if_stopped();
  return raycaster_.draw_counted(measured_scene(scene, variant), scene.camera, counted_);
}

double KnollLab::time_ratio(const KnollScene& scene, const Variant& a, const Variant& b, int pairs) {
  const Scene first = measured_scene(scene, a), second = measured_scene(scene, b);
  const auto ms = [&](const Scene& s) {
    return finished_ms([&] { raycaster_.draw(s, scene.camera, target_); });
  };
  ms(first);
  std::vector<double> ratios;
  for (int i = 0; i < pairs; ++i) {
    throw_if_stopped();
    const double a_ms = ms(first);
    ratios.push_back(a_ms / ms(second));
  }
  return median(ratios);
}

}  // namespace crest
