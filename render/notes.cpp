#include "render/notes.h"

#include <fmt/core.h>

#include <algorithm>
#include <glm/common.hpp>
#include <iterator>

#include "presets/choices.h"
#include "presets/names.h"
#include "render/classify/classification.h"
#include "render/raycaster/need.h"
#include "render/scene/exact.h"

namespace crest {
namespace {

constexpr float half_a_step = 0.5F / 255;

bool has_no_value(const Volume& volume) {
  return volume.statistics.nan_count + volume.statistics.inf_count == volume.grid.point_count();
}

/// Why a feature is left out; empty where it is not.
std::string why_without(const FeatureList& features, std::string_view name) {
  for (const auto& [feature, why] : features.left_out)
    if (feature == name) return why;
  return "";
}

/// The values that regions have throughout and at which the picture changes at once: at a step, at a spike's
/// tip, at a surface.
std::vector<float> regions_on_edges(const Scene& scene) {
  if (scene.volume->statistics.plateaus.empty()) return {};
  const Classification classification = classify(scene.tf, surface_range(scene));
  const auto& points = scene.tf.points;
  const auto is_edge = [&](float value) {
    const auto is_step = [&](const ControlPoint& a, const ControlPoint& b) {
      return float(a.value) == value && a.value == b.value && !(a.opacity == b.opacity && a.color == b.color);
    };
    const auto is_here = [&](const Peak& p) {
      return float(p.value) == value && (p.spike || (p.shown && shows_surfaces(scene.rendering.mode)));
    };
    return (shows_dvr(scene.rendering.mode) && std::ranges::adjacent_find(points, is_step) != points.end()) ||
           std::ranges::any_of(classification.peaks, is_here);
  };
  std::vector<float> edges;
  std::ranges::copy_if(scene.volume->statistics.plateaus, std::back_inserter(edges), is_edge);
  return edges;
}

std::string edge_note(const Scene& scene) {
  const Rendering& rendering = scene.rendering;
  const bool is_sampled = rendering.engine != Engine::reference && !is_analytic(rendering.classification);
  if (!is_sampled || !why_not_exact(rendering).empty()) return "";
  if (scene.volume->statistics.range.width() == 0) return "";
  const std::vector<float> edges = regions_on_edges(scene);
  if (edges.empty()) return "";
  const std::string values = edges.size() == 1 ? fmt::format("the value {:g}", edges.front())
                                               : fmt::format("values such as {:g}", edges.front());
  return fmt::format(
      "Regions of the volume have {} throughout, at which the transfer function has a step, a spike or a "
      "surface: samples beside it fall on either side. The exact picture (classification analytic, --exact) "
      "is right there.",
      values);
}

}  // namespace

std::vector<std::string> scene_notes(const Scene& scene) {
  const Volume& volume = *scene.volume;
  if (has_no_value(volume)) return {"No voxel has a value: all are NaN or infinite."};
  std::vector<std::string> notes;
  const ValueRange range = volume.statistics.range;
  if (range.width() == 0)
    notes.push_back(fmt::format("The volume is constant: every value is {:.6g}.", range.min));
  if (scene.tf.points.empty()) return notes;
  const ValueRange span = scene.tf.range();
  if (span.max < range.min || span.min > range.max)
    notes.push_back(
        fmt::format("No point of the transfer function, from {:.6g} to {:.6g}, lies in the volume's range, "
                    "from {:.6g} to {:.6g}: mapping it onto the range (--fit-range) would show it.",
                    span.min, span.max, range.min, range.max));
  if (std::string note = edge_note(scene); !note.empty()) notes.push_back(std::move(note));
  return notes;
}

bool has_visible_pixel(const Image& image, glm::vec3 background) {
  return std::ranges::any_of(image.pixels, [&](const glm::vec4& pixel) {
    const glm::vec3 change = glm::vec3(pixel) - pixel.a * background;
    return !(glm::all(glm::lessThan(glm::abs(change), glm::vec3(half_a_step))));
  });
}

std::string why_nothing_is_visible(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  const FeatureList features =
      find_need(*scene.volume, classify(scene.tf, surface_range(scene)), scene.rendering, camera, size, false)
          .list;
  const std::string no_dvr = why_without(features, "dvr"), no_peaks = why_without(features, "peaks");
  std::string why = "all that its rays meet is transparent, or has the background's colour";
  if (!no_dvr.empty() && !no_peaks.empty())
    why = no_dvr == no_peaks ? no_dvr : fmt::format("{}, and {}", no_dvr, no_peaks);
  return fmt::format("No pixel of {} is visible: {}.", name_of(scene.rendering.mode), why);
}

std::vector<std::string> picture_notes(const Scene& scene, const Camera& camera, const Image& image) {
  std::vector<std::string> notes = scene_notes(scene);
  if (!has_no_value(*scene.volume) && !has_visible_pixel(image, glm::vec3(scene.rendering.background)))
    notes.push_back(why_nothing_is_visible(scene, camera, image.size));
  return notes;
}

}  // namespace crest
