// ParaView's colour-map JSON, as "Export preset" writes it and Choose Preset > Import reads it
// (Kitware/ParaView: Remoting/Views/ColorMaps.json, vtkSMTransferFunctionPresets.cxx).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "presets/error.h"
#include "presets/export_formats.h"
#include "presets/json.h"

namespace crest {
namespace {

/// The points' values, strictly increasing: those that share one are moved down by as little as there is, so
/// that the last of them still holds at the value itself. ParaView sorts its nodes, and not stably.
std::vector<double> distinct_values(const TransferFunction& tf) {
  std::vector<double> values(tf.points.size());
  double limit = std::numeric_limits<double>::infinity();
  for (std::size_t i = values.size(); i-- > 0;) {
    values[i] = std::min(tf.points[i].value, limit);
    limit = std::nextafter(values[i], -std::numeric_limits<double>::infinity());
  }
  return values;
}

}  // namespace

std::string write_paraview(std::string_view preset_name, const TransferFunction& tf, const ExportOptions&) {
  if (tf.points.empty()) throw Error("a transfer function without points cannot be exported");
  using Json = nlohmann::ordered_json;
  const std::vector<double> values = distinct_values(tf);
  Json colors = Json::array(), opacities = Json::array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ControlPoint& point = tf.points[i];
    for (const double number : {values[i], point.color.r, point.color.g, point.color.b})
      colors.push_back(number);
    constexpr double midpoint = 0.5, sharpness = 0;  // straight lines
    for (const double number : {values[i], point.opacity, midpoint, sharpness}) opacities.push_back(number);
  }
  const Json map = {{"Name", preset_name.empty() ? "Crest" : preset_name},
                    {"Creator", "Crest"},
                    {"ColorSpace", "RGB"},
                    {"NanColor", {0.0, 0.0, 0.0}},
                    {"RGBPoints", std::move(colors)},
                    {"Points", std::move(opacities)}};
  return Json::array({map}).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string paraview_losses(const TransferFunction& tf, const ExportOptions&) {
  std::string losses = fmt::format(
      "the unit distance is not in the file: set ScalarOpacityUnitDistance of the representation to {}\n",
      unit_distance_text(tf));
  const auto shared = std::adjacent_find(tf.points.begin(), tf.points.end(),
                                         [](const auto& a, const auto& b) { return a.value == b.value; });
  if (shared != tf.points.end())
    losses += "points that share a value are written one representable number apart\n";
  return losses + surface_losses(tf);
}

}  // namespace crest
