// Inviwo's transfer functions, .itf of version 3 (inviwo/inviwo: data/transferfunctions,
// TFPrimitiveSet::serialize). Opacity there is that of 1/150 of the volume's side.
#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "presets/exchange/formats.h"
#include "presets/exchange/steps.h"
#include "presets/exchange/vtk_model.h"
#include "presets/exchange/words.h"

namespace crest {
namespace {

glm::dvec3 size_of(const ExportVolume& volume) { return glm::dvec3(volume.dims) * volume.spacing; }

bool is_cube(const glm::dvec3& size) {
  return std::max({size.x, size.y, size.z}) < 1.01 * std::min({size.x, size.y, size.z});
}

/// Inviwo's rays have a length in shares of the box: in one that is not a cube a share is another length
/// along each axis, and that of the mean side is taken.
TransferFunction in_inviwo_units(const ExportInput& input) {
  TransferFunction tf = input.preset.transfer_function;
  if (input.volume) tf = with_unit_distance(tf, inviwo_share * mean_side(size_of(*input.volume)));
  return tf;
}

}  // namespace

Exported write_inviwo(const ExportInput& input) {
  const TransferFunction tf = in_inviwo_units(input);
  const std::vector<double> values = separated_values(tf, drawn_apart);
  constexpr int absolute = 1;  // positions are values of the data
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "<?xml version=\"1.0\" encoding=\"UTF-8\" ?>\n<InviwoWorkspace version=\"3\">\n"
                 "    <maskMin content=\"0\" />\n    <maskMax content=\"1\" />\n    <type content=\"{}\" />\n"
                 "    <Points>\n",
                 absolute);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ControlPoint& p = tf.points[i];
    fmt::format_to(out,
                   "        <Point>\n            <pos content=\"{}\" />\n"
                   "            <rgba x=\"{}\" y=\"{}\" z=\"{}\" w=\"{}\" />\n        </Point>\n",
                   values[i], p.color.r, p.color.g, p.color.b, p.opacity);
  }
  text += "    </Points>\n</InviwoWorkspace>\n";
  Exported result;
  result.files.push_back({"", std::move(text)});
  say_moved(tf, values, result.losses);
  if (!input.volume)
    result.losses.push_back(fmt::format(
        "Inviwo's opacity is that of 1/150 of the volume's side, which is not known without a volume: "
        "opacities are written as they are, for {} world units",
        number(tf.unit_distance)));
  else if (!is_cube(size_of(*input.volume)))
    result.losses.emplace_back(
        "the volume is not a cube: Inviwo's opacity then depends on the direction of view, and that of "
        "its mean side is written");
  say_no_peaks(input, result.losses);
  say_no_surface_settings(input, result.losses);
  say_no_rendering(input, result.losses);
  result.advice.emplace_back("in the transfer function's editor: Import, then choose the file");
  return result;
}

// Its table has 1024 entries (TransferFunction::defaultTextureSize), its sampling two samples a voxel.
Preset drawn_by_inviwo(const ExportInput& input) {
  const TransferFunction tf = in_inviwo_units(input);
  Preset drawn = in_vtk_settings(input.preset);
  drawn.transfer_function = tabled(tf, separated_values(tf, drawn_apart), range_there(input), 1024);
  drawn.rendering.step = 0.5;
  return drawn;
}

}  // namespace crest
