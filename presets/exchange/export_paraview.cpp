// ParaView's colour-map JSON, as "Export preset" writes it and Choose Preset > Import reads it
// (Kitware/ParaView: Remoting/Views/ColorMaps.json, vtkSMTransferFunctionPresets.cxx).
#include <fmt/core.h>

#include <cstdint>

#include "presets/exchange/flat_points.h"
#include "presets/exchange/formats.h"
#include "presets/exchange/steps.h"
#include "presets/exchange/vtk_model.h"
#include "presets/exchange/words.h"
#include "presets/json.h"
#include "presets/json_text.h"

namespace crest {
namespace {

/// Of what is written: FNV-1a. ParaView stores a second preset of a known name without any.
std::uint32_t hash_of(const Json& map) {
  std::uint32_t hash = 2166136261u;
  for (const char c : map.dump()) hash = (hash ^ std::uint8_t(c)) * 16777619u;
  return hash;
}

}  // namespace

Exported write_paraview(const ExportInput& input) {
  const TransferFunction& tf = input.preset.transfer_function;
  const std::vector<double> values = separated_values(tf, drawn_apart);
  const std::vector<double> straight{0.5, 0};  // midpoint, sharpness
  Json map = {{"Creator", "Crest"},
              {"ColorSpace", "RGB"},
              {"Discretize", 0},  // else colours come from 256 entries
              {"NanColor", {0.0, 0.0, 0.0}},
              {"RGBPoints", flat_colors(tf, values)},
              {"Points", flat_opacities(tf, values, straight)}};
  const std::string name = fmt::format("{} {:06x}", input.name, hash_of(map) & 0xffffffu);
  map["Name"] = name;
  Exported result;
  result.files.push_back({"", Json::array({map}).dump(1, ' ', false, Json::error_handler_t::replace) + "\n"});
  say_moved(tf, values, result.losses);
  result.losses.emplace_back(
      "the unit distance is not in the file: ParaView takes the size of a cell, whatever the volume");
  say_no_peaks(input, result.losses);
  say_no_surface_settings(input, result.losses);
  say_no_rendering(input, result.losses);
  result.advice.emplace_back(
      fmt::format("in the Color Map Editor: Choose Preset > Import, choose \"{}\", tick "
                  "Opacities and Use preset range, "
                  "Apply",
                  name));
  result.advice.emplace_back(fmt::format(
      "set Scalar Opacity Unit Distance, in the volume's properties, to {}", number(tf.unit_distance)));
  return result;
}

// As somebody sees it who did what the advice says
Preset drawn_by_paraview(const ExportInput& input) {
  return drawn_by_vtk(input, separated_values(input.preset.transfer_function, drawn_apart),
                      input.preset.transfer_function.unit_distance);
}

}  // namespace crest
