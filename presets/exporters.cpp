#include "presets/exporters.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/error.h"
#include "presets/export_formats.h"

namespace crest {

std::span<const Exporter> exporters() {
  static constexpr Exporter table[] = {
      {"paraview", ".json", "ParaView's colour map with its opacity points", write_paraview, paraview_losses},
      {"csv", ".csv", "a table of equidistant values with colour, opacity and extinction", write_csv,
       csv_losses},
  };
  return table;
}

const Exporter& find_exporter(std::string_view name) {
  std::string names;
  for (const Exporter& exporter : exporters()) {
    if (exporter.name == name) return exporter;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", exporter.name);
  }
  throw Error(fmt::format("{}: no such export format; there are: {}", name, names));
}

std::string unit_distance_text(const TransferFunction& tf) {
  return fmt::format("{} {}", tf.unit_distance,
                     tf.unit == LengthUnit::voxel ? "times the smallest spacing" : "world units");
}

std::string surface_losses(const TransferFunction& tf) {
  const auto count = std::count_if(tf.points.begin(), tf.points.end(),
                                   [](const ControlPoint& p) { return p.surface != Surface{}; });
  return count == 0
             ? ""
             : fmt::format("surface settings are not in the file (points that have them: {})\n", count);
}

}  // namespace crest
