#include "render/studies/placement/volume_placement.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "presets/names.h"
#include "render/measure/method_convergence.h"
#include "render/measure/timing.h"
#include "render/reference/reference.h"
#include "render/scene/camera.h"
#include "render/studies/placement/square.h"

namespace crest {
namespace {

void throw_if_stopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Cancelled();
}

Scene with(const Scene& scene, Placement placement, double step) {
  Scene result = scene;
  result.rendering.placement = placement;
  result.rendering.step = step;
  return result;
}

VolumePlacement study_placement(Raycaster& raycaster, const VolumeStudy& study, Placement placement,
                                const std::stop_token& stop) {
  VolumePlacement result{placement, {}, {}, {}};
  const auto& [id, title, note, scene, camera] = study.scene;
  gl::RenderTarget target(study.size, false), counted(study.size, true);
  std::vector<double> rmse;
  for (const double step : study_steps) {
    throw_if_stopped(stop);
    const Scene placed = with(scene, placement, step);
    raycaster.draw(placed, camera, target);
    const Image image = target.read_color();
    const auto counts = raycaster.draw_counted(placed, camera, counted);
    const auto background = glm::vec3(scene.rendering.background);
    result.points.push_back(
        {step, image_error(study.exact, image, {}, background), counts.dvr_samples / counts.pixels});
    rmse.push_back(result.points.back().error.compared.rmse);
    if (step == pictured_step) result.picture = image;
  }
  if (rmse.front() > rounding_rmse) result.order = fit_finest_order(study_steps, rmse);
  return result;
}

}  // namespace

VolumeStudy study_volume(Raycaster& raycaster, const PlacementScene& scene, glm::ivec2 size,
                         std::stop_token stop) {
  VolumeStudy study{scene, size, {}, {}};
  study.exact = render_reference(scene.scene, scene.camera, size, Answer::integral, default_tolerance,
                                 [&](double) { return !stop.stop_requested(); });
  for (const auto& [placement, name] : names_of<Placement>())
    study.placements.push_back(study_placement(raycaster, study, placement, stop));
  return study;
}

double distance_from_plane(const VolumeStudy& study) {
  const Square square = linear_square();
  const double half_height = std::tan(glm::radians(study.scene.camera.fov_y_degrees) / 2);
  const int row = study.size.y / 2;
  double largest = 0;
  for (int x = 0; x < study.size.x; ++x) {
    const double across = (2 * (x + 0.5) / study.size.x - 1) * half_height * study.size.x / study.size.y;
    const auto ray = fan_ray(-std::atan(across));  // right in the picture is down in the plane
    const double exact = ray ? exact_intensity(square, *ray) / 2 : 0;
    const auto pixel = std::size_t(row) * std::size_t(study.size.x) + std::size_t(x);
    largest = std::max(largest, std::abs(study.exact.pixels[pixel].a - exact));
  }
  return largest;
}

std::vector<ClipDifference> clip_against_crop(Raycaster& raycaster, const PlacementScene& clipped,
                                              glm::ivec2 size) {
  const Scene crop = cropped(clipped.scene);
  gl::RenderTarget target(size, false);
  const auto draw = [&](const Scene& scene) {
    raycaster.draw(scene, clipped.camera, target);
    return target.read_color();
  };
  std::vector<ClipDifference> result;
  for (const auto& [placement, name] : names_of<Placement>()) {
    const Image a = draw(with(clipped.scene, placement, pictured_step)),
                b = draw(with(crop, placement, pictured_step));
    ClipDifference difference{placement};
    std::size_t seen = 0;
    const auto differences = pixel_differences(a, b);
    for (std::size_t i = 0; i < differences.size(); ++i) {
      difference.max = std::max(difference.max, double(differences[i]));
      seen += differences[i] > 1.0F / 255;
      difference.pixels += a.pixels[i].a > 0;
    }
    difference.share = double(seen) / double(differences.size());
    result.push_back(difference);
  }
  return result;
}

std::vector<PlacementTime> time_placements(Raycaster& raycaster, const PlacementScene& scene, double step,
                                           glm::ivec2 size, int rounds, std::stop_token stop) {
  std::vector<PlacementTime> times;
  for (const auto& [placement, name] : names_of<Placement>()) times.push_back({placement, false, {}});
  times.push_back({Placement::entry_exit_corner, true, {}});
  gl::RenderTarget target(size, false), counted(size, true);
  for (PlacementTime& time : times) {  // uploads and compiles, too
    const auto counts =
        raycaster.draw_counted(with(scene.scene, time.placement, step), scene.camera, counted);
    time.dvr_samples_per_ray = counts.dvr_samples / counts.pixels;
    raycaster.draw(with(scene.scene, time.placement, step), scene.camera, target);
  }
  for (int round = 0; round < rounds; ++round) {
    throw_if_stopped(stop);
    for (std::size_t i = 0; i < times.size(); ++i) {
      PlacementTime& time = times[(i + std::size_t(round)) % times.size()];
      const Scene placed = with(scene.scene, time.placement, step);
      time.frame_ms.push_back(finished_ms([&] { raycaster.draw(placed, scene.camera, target); }));
    }
  }
  const auto base =
      std::ranges::find(times, Placement::entry_exit_corner, &PlacementTime::placement)->frame_ms;
  for (PlacementTime& time : times) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < base.size(); ++i) ratios.push_back(time.frame_ms[i] / base[i]);
    time.median_ms = median(time.frame_ms);
    time.ratio = median(ratios);
  }
  return times;
}

}  // namespace crest
