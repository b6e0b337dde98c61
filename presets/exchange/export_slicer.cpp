// 3D Slicer's volume properties: .vp.json since 5.10 (Modules/Loadable/VolumeRendering/Resources/Schema/
// volume-property-schema-v1.0.0.json), and the older text, .vp, which has no unit distance.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include "presets/exchange/contributions.h"
#include "presets/exchange/formats.h"
#include "presets/exchange/steps.h"
#include "presets/exchange/vtk_model.h"
#include "presets/exchange/words.h"
#include "presets/json.h"
#include "presets/json_text.h"

namespace crest {
namespace {

/// Of Crest's headlight (render/shaders/shading.glsl).
constexpr double ambient = 0.25, diffuse = 0.75;

bool is_shaded(const ExportInput& input) { return input.preset.rendering.shading != Shading::none; }

/// The schema wants midpoint and sharpness in each point: straight lines.
Json json_points(const TransferFunction& tf, const std::vector<double>& values, bool colors) {
  Json points = Json::array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ControlPoint& p = tf.points[i];
    Json point = {{"x", values[i]}};
    if (colors)
      point["color"] = {p.color.r, p.color.g, p.color.b};
    else
      point["y"] = p.opacity;
    point["midpoint"] = 0.5;
    point["sharpness"] = 0.0;
    points.push_back(std::move(point));
  }
  return points;
}

Json iso_values(const ExportInput& input) {
  Json values = Json::array();
  for (const Peak& peak : shown_contributions(input.preset).surfaces) values.push_back(peak.value);
  return values;
}

/// What both forms lose.
void say_slicer_losses(const ExportInput& input, const std::vector<double>& values, Exported& result) {
  say_moved(input.preset.transfer_function, values, result.losses);
  say_no_peaks(input, result.losses);
  say_no_surface_settings(input, result.losses);
  say_dark_where_flat(input, result.losses);
  say_no_rendering(input, result.losses);
  result.advice.emplace_back(
      "in the module Volume Rendering: drag the file onto the window, then choose it as the volume "
      "property under Inputs");
}

/// "COUNT number number ...".
std::string text_row(const std::vector<double>& numbers) {
  return fmt::format("{} {}\n", numbers.size(), fmt::join(numbers, " "));
}

}  // namespace

Exported write_slicer(const ExportInput& input) {
  const TransferFunction& tf = input.preset.transfer_function;
  const std::vector<double> values = separated_values(tf, slicer_apart);
  const ValueRange range = input.volume ? input.volume->range : tf.range();
  const Json lighting = {
      {"diffuse", diffuse}, {"ambient", ambient}, {"specular", 0.0}, {"specularPower", 1.0}};
  const Json component = {
      {"shade", is_shaded(input)},
      {"lighting", lighting},
      {"rgbTransferFunction", {{"type", "colorTransferFunction"}, {"points", json_points(tf, values, true)}}},
      {"scalarOpacityUnitDistance", tf.unit_distance},
      {"scalarOpacity", {{"type", "piecewiseLinearFunction"}, {"points", json_points(tf, values, false)}}},
      {"gradientOpacity",
       {{"type", "piecewiseLinearFunction"},
        {"points", Json::array({{{"x", 0.0}, {"y", 1.0}, {"midpoint", 0.5}, {"sharpness", 0.0}}})}}}};
  const Json file = {{"@schema",
                      "https://raw.githubusercontent.com/slicer/slicer/main/Modules/Loadable/VolumeRendering/"
                      "Resources/Schema/"
                      "volume-property-schema-v1.0.0.json#"},
                     {"volumeProperties", Json::array({{{"name", input.name},
                                                        {"effectiveRange", {range.min, range.max}},
                                                        {"isoSurfaceValues", iso_values(input)},
                                                        {"interpolationType", "linear"},
                                                        {"components", Json::array({component})}}})}};
  Exported result;
  result.files.push_back({"", file.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"});
  say_slicer_losses(input, values, result);
  return result;
}

Preset drawn_by_slicer(const ExportInput& input) {
  const TransferFunction& tf = input.preset.transfer_function;
  return drawn_by_vtk(input, separated_values(tf, slicer_apart), tf.unit_distance);
}

Exported write_slicer_vp(const ExportInput& input) {
  const TransferFunction tf = with_unit_distance(input.preset.transfer_function, 1);
  const std::vector<double> values = separated_values(tf, slicer_apart);
  std::vector<double> opacities, colors;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ControlPoint& p = tf.points[i];
    opacities.insert(opacities.end(), {values[i], p.opacity});
    colors.insert(colors.end(), {values[i], p.color.r, p.color.g, p.color.b});
  }
  constexpr int linear = 1;
  std::string text = fmt::format("{}\n{}\n{}\n{}\n0\n1\n", linear, int(is_shaded(input)), diffuse, ambient);
  text += text_row(opacities) + text_row({0, 1}) + text_row(colors);
  Exported result;
  result.files.push_back({"", text});
  say_slicer_losses(input, values, result);
  if (input.preset.transfer_function.unit_distance != 1)
    result.losses.push_back(fmt::format(
        "the unit distance is not in the file: opacities are written for 1 world unit in place of {}",
        number(input.preset.transfer_function.unit_distance)));
  return result;
}

Preset drawn_by_slicer_vp(const ExportInput& input) {
  ExportInput scaled = input;
  TransferFunction& tf = scaled.preset.transfer_function;
  tf = with_unit_distance(tf, 1);
  return drawn_by_vtk(scaled, separated_values(tf, slicer_apart), 1);
}

}  // namespace crest
