// vtk.js's and VolView's colour maps: the object that vtkColorMaps.addPreset takes, with opacities beside the
// colours (Kitware/VolView: src/vtk/MedicalColorPresets.json).
#include <fmt/core.h>

#include "presets/exchange/formats.h"
#include "presets/exchange/steps.h"
#include "presets/exchange/vtk_model.h"
#include "presets/exchange/words.h"
#include "presets/json.h"
#include "presets/json_text.h"

namespace crest {

Exported write_vtkjs(const ExportInput& input) {
  const TransferFunction& tf = input.preset.transfer_function;
  const std::vector<double> values = separated_values(tf, drawn_apart);
  Json colors = Json::array(), opacities = Json::array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ControlPoint& p = tf.points[i];
    for (const double n : {values[i], p.color.r, p.color.g, p.color.b}) colors.push_back(n);
    for (const double n : {values[i], p.opacity}) opacities.push_back(n);
  }
  const Json map = {{"Name", input.name},
                    {"Creator", "Crest"},
                    {"ColorSpace", "RGB"},
                    {"RGBPoints", std::move(colors)},
                    {"OpacityPoints", std::move(opacities)}};
  Exported result;
  result.files.push_back({"", map.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"});
  say_moved(tf, values, result.losses);
  result.losses.emplace_back("the unit distance is not in the file");
  say_no_peaks(input, result.losses);
  say_no_surface_settings(input, result.losses);
  say_no_rendering(input, result.losses);
  result.advice.emplace_back(
      fmt::format("property.setScalarOpacityUnitDistance(0, {}); then addPoint(x, opacity) for each pair of "
                  "OpacityPoints, "
                  "addRGBPoint(x, r, g, b) for each four of RGBPoints",
                  number(tf.unit_distance)));
  result.advice.emplace_back(
      "VolView has its presets built in: put the object into src/vtk/MedicalColorPresets.json and build it");
  return result;
}

Preset drawn_by_vtkjs(const ExportInput& input) {
  const TransferFunction& tf = input.preset.transfer_function;
  Preset drawn = drawn_by_vtk(input, separated_values(tf, drawn_apart), tf.unit_distance);
  TransferFunction read = tf;
  const std::vector<double> values = separated_values(tf, drawn_apart);
  for (std::size_t i = 0; i < values.size(); ++i) read.points[i].value = values[i];
  ValueRange range = input.volume ? input.volume->range : tf.range();
  if (!(range.width() > 0)) range.max = range.min + 1;
  drawn.transfer_function =
      tabled(read, range, 1024);  // Sources/Rendering/OpenGL/VolumeMapper: one size for all
  return drawn;
}

}  // namespace crest
