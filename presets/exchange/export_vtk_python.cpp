// A Python module that builds a vtkVolumeProperty, for everything that has VTK in it.
#include <fmt/core.h>

#include <iterator>

#include "presets/exchange/contributions.h"
#include "presets/exchange/formats.h"
#include "presets/exchange/script_text.h"
#include "presets/exchange/steps.h"
#include "presets/exchange/vtk_model.h"
#include "presets/exchange/words.h"

namespace crest {
namespace {

constexpr const char* functions = R"(

def volume_property():
    """The transfer function, as a vtkVolumeProperty."""
    color = vtk.vtkColorTransferFunction()
    opacity = vtk.vtkPiecewiseFunction()
    color.AllowDuplicateScalarsOn()
    opacity.AllowDuplicateScalarsOn()
    for value, red, green, blue, alpha in POINTS:
        color.AddRGBPoint(value, red, green, blue)
        opacity.AddPoint(value, alpha)
    result = vtk.vtkVolumeProperty()
    result.SetColor(color)
    result.SetScalarOpacity(opacity)
    result.SetScalarOpacityUnitDistance(UNIT_DISTANCE)
    result.SetInterpolationTypeToLinear()
    result.SetShade(SHADED)
    result.SetAmbient(AMBIENT)
    result.SetDiffuse(DIFFUSE)
    result.SetSpecular(0)
    return result


def peak_actors(image):
    """Each peak as an isosurface, a vtkActor, of a vtkImageData or an output port."""
    actors = []
    for value, red, green, blue, alpha in PEAKS:
        contour = vtk.vtkContourFilter()
        if image.IsA("vtkAlgorithmOutput"):
            contour.SetInputConnection(image)
        else:
            contour.SetInputData(image)
        contour.SetValue(0, value)
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(contour.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(red, green, blue)
        actor.GetProperty().SetOpacity(alpha)
        actor.GetProperty().SetAmbient(AMBIENT)
        actor.GetProperty().SetDiffuse(DIFFUSE)
        actor.GetProperty().SetLighting(SHADED)
        actors.append(actor)
    return actors
)";

}  // namespace

Exported write_vtk_python(const ExportInput& input) {
  const ShownContributions shown = shown_contributions(input.preset);
  const std::vector<double> values = separated_values(shown.dvr, drawn_apart);
  std::string text = fmt::format(
      "# Written by Crest from the preset \"{}\": for VTK 8 to 9.7, pyvista, Mayavi, trame, 3D Slicer's "
      "console.\n"
      "#   volume.SetProperty(volume_property()); for actor in peak_actors(image): renderer.AddActor(actor)\n"
      "import vtk\n\n"
      "UNIT_DISTANCE = {}  # what an opacity is for, in world units\n"
      "SHADED = {}\n"
      "AMBIENT, DIFFUSE = 0.25, 0.75\n",
      one_line(input.name), number(shown.dvr.unit_distance),
      input.preset.rendering.shading == Shading::none ? "False" : "True");
  text += "POINTS = " + python_points(shown.dvr, values);
  text += "PEAKS = " + python_peaks(shown.surfaces);
  text += functions;
  Exported result;
  result.files.push_back({"", std::move(text)});
  say_moved(shown.dvr, values, result.losses);
  if (!shown.shows_dvr) result.losses.emplace_back("the mode is PEAK_ONLY: add only the actors of the peaks");
  if (!shown.surfaces.empty())
    result.losses.emplace_back(
        "the peaks are isosurfaces of triangles there: VTK draws them before the volume, or, where they "
        "are translucent, over it");
  say_dark_where_flat(input, result.losses);
  say_no_rendering(input, result.losses);
  result.advice.emplace_back("pyvista: plotter.add_volume(image).prop = volume_property()");
  result.advice.emplace_back(
      "3D Slicer: displayNode.GetVolumePropertyNode().GetVolumeProperty().DeepCopy(volume_property())");
  return result;
}

Preset drawn_by_vtk_python(const ExportInput& input) {
  const ShownContributions shown = shown_contributions(input.preset);
  return drawn_by_vtk_with_contours(input, shown, separated_values(shown.dvr, drawn_apart));
}

}  // namespace crest
