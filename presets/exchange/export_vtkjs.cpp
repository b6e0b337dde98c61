// vtk.js's and VolView's colour maps: the object that vtkColorMaps.addPreset takes, with opacities beside the
// colours (Kitware/VolView: src/vtk/MedicalColorPresets.json).
#include <fmt/core.h>

#include "presets/exchange/flat_points.h"
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
  const Json map = {{"Name", input.name},
                    {"Creator", "Crest"},
                    {"ColorSpace", "RGB"},
                    {"RGBPoints", flat_colors(tf, values)},
                    {"OpacityPoints", flat_opacities(tf, values, {})}};
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

// One size for all tables (Sources/Rendering/OpenGL/VolumeMapper)
Preset drawn_by_vtkjs(const ExportInput& input) {
  Preset drawn = in_vtk_settings(input.preset);
  TransferFunction& tf = drawn.transfer_function;
  tf = tabled(tf, separated_values(tf, drawn_apart), range_there(input), 1024);
  return drawn;
}

}  // namespace crest
