#include "presets/exchange/words.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "presets/choices.h"
#include "presets/exchange/contributions.h"
#include "presets/exchange/steps.h"
#include "presets/peaks.h"

namespace crest {

void say_no_peaks(const ExportInput& input, std::vector<std::string>& losses) {
  const ShownContributions shown = shown_contributions(input.preset);
  if (!shown.shows_dvr)
    losses.emplace_back(
        "the mode is PEAK_ONLY: the target draws the whole transfer function, where only its peaks show "
        "here");
  const std::vector<Peak>& surfaces = shown.surfaces;
  if (surfaces.empty()) return;
  std::string values;
  for (std::size_t i = 0; i < std::min<std::size_t>(surfaces.size(), 4); ++i)
    values += fmt::format("{}{}", i == 0 ? "" : ", ", short_number(surfaces[i].value));
  if (surfaces.size() > 4) values += ", ...";
  losses.push_back(
      fmt::format("{} {} not drawn as a surface there, only sampled as opacity, and may be missed between "
                  "samples (at {})",
                  surfaces.size(), surfaces.size() == 1 ? "peak is" : "peaks are", values));
}

void say_no_surface_settings(const ExportInput& input, std::vector<std::string>& losses) {
  const auto count = std::ranges::count_if(input.preset.transfer_function.points,
                                           [](const ControlPoint& p) { return p.surface != Surface{}; });
  if (count > 0)
    losses.push_back(fmt::format("surface settings are not in the file ({} {} them)", count,
                                 count == 1 ? "point has" : "points have"));
}

void say_moved(const TransferFunction& tf, const std::vector<double>& values,
               std::vector<std::string>& losses) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) count += values[i] != tf.points[i].value;
  if (count > 0)
    losses.push_back(fmt::format("{} {} moved by up to {:.2g}, since the target keeps points apart", count,
                                 count == 1 ? "point is" : "points are", farthest_move(tf, values)));
}

void say_no_rendering(const ExportInput& input, std::vector<std::string>& losses) {
  const Rendering& r = input.preset.rendering;
  if (r.filter == Filter::bspline || r.filter == Filter::bc)
    losses.emplace_back("the cubic filter is not in the file: the target interpolates linearly");
  if (r.blend_mode != BlendMode::semi_transparent)
    losses.emplace_back(
        "rendering.illumination is not in the file: the target shows the volume rendering integral");
  if (r.clip_box) losses.emplace_back("the clip box is not in the file");
}

void say_dark_where_flat(const ExportInput& input, std::vector<std::string>& losses) {
  if (input.preset.rendering.shading != Shading::none && shows_dvr(input.preset.rendering.mode))
    losses.emplace_back(
        "a shaded volume is dark there where the field is flat, and in full light here: switch shading off "
        "where haze shows");
}

std::string number(double value) { return fmt::format("{}", value); }
std::string short_number(double value) { return fmt::format("{:.6g}", value); }

double mean_side(const glm::dvec3& size) { return std::cbrt(size.x * size.y * size.z); }

double opacity_over(double opacity, double from, double to) {
  if (opacity >= 1 || from == to) return opacity;
  return -std::expm1(std::log1p(-opacity) * (to / from));
}

TransferFunction with_unit_distance(TransferFunction tf, double unit_distance) {
  for (ControlPoint& point : tf.points) {
    point.opacity = opacity_over(point.opacity, tf.unit_distance, unit_distance);
  }
  tf.unit_distance = unit_distance;
  return tf;
}

}  // namespace crest
