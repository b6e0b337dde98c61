// A program for pvpython and pvbatch that draws the preset in ParaView: all that a colour map's file cannot
// hold.
#include <fmt/core.h>

#include <algorithm>

#include "presets/exchange/contributions.h"
#include "presets/exchange/formats.h"
#include "presets/exchange/script_text.h"
#include "presets/exchange/steps.h"
#include "presets/exchange/vtk_model.h"
#include "presets/exchange/words.h"

namespace crest {
namespace {

std::string python_vector(const glm::dvec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

std::string vtk_type(const std::string& type) {
  if (type == "float32") return "float";
  if (type == "float64") return "double";
  const bool is_unsigned = type.starts_with('u');
  const std::string bits = type.substr(type.find('t') + 1);
  const std::string word = bits == "8" ? "char" : bits == "16" ? "short" : bits == "32" ? "int" : "long";
  return (is_unsigned ? "unsigned " : "") + word;
}

/// The reader: ParaView's own choice by the file's name, or for a file without a header all that it has to be
/// told.
std::string reader_of(const std::optional<ExportVolume>& volume) {
  if (!volume || !volume->raw) return "reader = OpenDataFile(FILE)\n";
  const ExportVolume::Raw& raw = *volume->raw;
  const glm::ivec3 last = volume->dims - 1;
  return fmt::format(
      "reader = ImageReader(FileNames=[FILE], FileDimensionality=3,\n"
      "                     DataScalarType=\"{}\", DataByteOrder=\"{}\", NumberOfScalarComponents=1,\n"
      "                     DataExtent=[0, {}, 0, {}, 0, {}], DataSpacing={}, DataOrigin={})\n",
      vtk_type(raw.type), raw.big_endian ? "BigEndian" : "LittleEndian", last.x, last.y, last.z,
      python_vector(volume->spacing), python_vector(volume->origin));
}

bool is_read_by_paraview(const ExportVolume& volume) {
  constexpr std::string_view known[] = {".nrrd", ".nhdr", ".mhd", ".mha",  ".vtk", ".vti",
                                        ".pvti", ".mrc",  ".tif", ".tiff", ".dcm"};
  return volume.raw ||
         std::ranges::any_of(known, [&](auto extension) { return volume.file.ends_with(extension); });
}

std::string camera_of_view(const std::optional<Camera>& camera) {
  if (!camera) return "view.ResetCamera()\n";
  const std::string perspective = fmt::format(
      "view.CameraPosition = {}\nview.CameraFocalPoint = {}\nview.CameraViewUp = {}\nview.CameraViewAngle = "
      "{}\n",
      python_vector(camera->eye), python_vector(camera->target), python_vector(camera->up),
      camera->fov_y_degrees);
  if (camera->projection == Projection::perspective) return perspective;
  return perspective + fmt::format("view.CameraParallelProjection = 1\nview.CameraParallelScale = {}\n",
                                   half_height_at_target(*camera));
}

constexpr const char* head =
    R"(# Written by Crest from the preset "{name}", for ParaView 5.11 to 6. Draws a picture:
#   pvbatch {stem}.py [VOLUME [PICTURE]]
#   mpirun -n 8 pvbatch {stem}.py [VOLUME [PICTURE]]
import sys
from paraview.simple import *

FILE = sys.argv[1] if len(sys.argv) > 1 else {file}
PICTURE = sys.argv[2] if len(sys.argv) > 2 else {picture}
UNIT_DISTANCE = {unit}  # what an opacity is for, in world units
SHADED = {shaded}
)";

constexpr const char* body = R"(
{reader}reader.UpdatePipeline()
array = reader.PointData.GetArray(0).Name

view = CreateRenderView(ViewSize=[{width}, {height}], OrientationAxesVisibility=0)
view.UseColorPaletteForBackground = 0
view.BackgroundColorMode = "Single Color"
view.Background = {background}
)";

constexpr const char* volume_part = R"(
# The transfer function
volume = Show(reader, view, "UniformGridRepresentation")
volume.SetRepresentationType("Volume")
ColorBy(volume, ("POINTS", array))
color = GetColorTransferFunction(array)
color.ColorSpace = "RGB"
color.Discretize = 0
color.RGBPoints = [number for v, r, g, b, a in POINTS for number in (v, r, g, b)]
opacity = GetOpacityTransferFunction(array)
opacity.Points = [number for v, r, g, b, a in POINTS for number in (v, a, 0.5, 0)]
volume.ScalarOpacityUnitDistance = UNIT_DISTANCE
volume.Shade = SHADED
volume.Ambient, volume.Diffuse, volume.Specular = 0.25, 0.75, 0
volume.SetScalarBarVisibility(view, False)
)";

constexpr const char* peaks_part = R"(
# Each peak, as a surface
for value, red, green, blue, alpha in PEAKS:
    contour = Contour(Input=reader, ContourBy=["POINTS", array], Isosurfaces=[value], ComputeScalars=0)
    surface = Show(contour, view)
    surface.ColorArrayName = ["POINTS", ""]
    surface.AmbientColor = surface.DiffuseColor = [red, green, blue]
    surface.Opacity = alpha
    surface.Ambient, surface.Diffuse, surface.Specular = (0.25, 0.75, 0) if SHADED else (1, 0, 0)
)";

constexpr const char* tail = R"(
{camera}SaveScreenshot(PICTURE, view, ImageResolution=[{width}, {height}])
)";

}  // namespace

Exported write_paraview_script(const ExportInput& input) {
  const ShownContributions shown = shown_contributions(input.preset);
  const std::vector<double> values = separated_values(shown.dvr, drawn_apart);
  const bool is_shaded = input.preset.rendering.shading != Shading::none;
  const bool has_file = input.volume && !input.volume->file.empty();
  std::string text =
      fmt::format(head, fmt::arg("name", one_line(input.name)), fmt::arg("stem", one_line(input.stem)),
                  fmt::arg("file", python_string(has_file ? input.volume->file : "VOLUME")),
                  fmt::arg("picture", python_string(input.stem + ".png")),
                  fmt::arg("unit", shown.dvr.unit_distance), fmt::arg("shaded", int(is_shaded)));
  if (shown.shows_dvr) text += "POINTS = " + python_points(shown.dvr, values);
  if (!shown.surfaces.empty()) text += "PEAKS = " + python_peaks(shown.surfaces);
  text += fmt::format(body, fmt::arg("reader", reader_of(input.volume)), fmt::arg("width", input.size.x),
                      fmt::arg("height", input.size.y),
                      fmt::arg("background", python_vector(input.preset.rendering.background)));
  if (shown.shows_dvr) text += volume_part;
  if (!shown.surfaces.empty()) text += peaks_part;
  text += fmt::format(tail, fmt::arg("camera", camera_of_view(input.preset.camera)),
                      fmt::arg("width", input.size.x), fmt::arg("height", input.size.y));

  Exported result;
  result.files.push_back({"", std::move(text)});
  if (shown.shows_dvr) say_moved(shown.dvr, values, result.losses);
  if (!shown.surfaces.empty())
    result.losses.emplace_back(
        "the peaks are isosurfaces of triangles there: where they are translucent, ParaView draws them "
        "over the volume, not within it");
  if (has_file && !is_read_by_paraview(*input.volume))
    result.losses.push_back(
        fmt::format("ParaView may not read {} as it comes (NIfTI: Tools > Manage Plugins > "
                    "AnalyzeNIfTIReaderWriter)",
                    input.volume->name));
  if (!has_file)
    result.losses.emplace_back(
        "the volume is not in a file that ParaView could read: give one to the script");
  say_dark_where_flat(input, result.losses);
  say_no_rendering(input, result.losses);
  result.advice.push_back(
      fmt::format("pvbatch {0}.py; on 8 processes: mpirun -n 8 pvbatch {0}.py", input.stem));
  return result;
}

Preset drawn_by_paraview_script(const ExportInput& input) {
  const ShownContributions shown = shown_contributions(input.preset);
  return drawn_by_vtk_with_contours(input, shown, separated_values(shown.dvr, drawn_apart));
}

}  // namespace crest
