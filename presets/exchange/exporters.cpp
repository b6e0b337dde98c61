#include "presets/exchange/exporters.h"

#include <fmt/format.h>

#include <algorithm>

#include "presets/error.h"
#include "presets/exchange/formats.h"
#include "presets/nearest_word.h"

namespace crest {

std::span<const Exporter> exporters() {
  static constexpr bool table = true;
  static constexpr Exporter list[] = {
      {"paraview", "ParaView", ".json", "ParaView's colour map with its opacity points", write_paraview,
       drawn_by_paraview},
      {"paraview-script", "ParaView script", ".py",
       "a program for pvpython and pvbatch, with the peaks as contours", write_paraview_script,
       drawn_by_paraview_script},
      {"slicer", "3D Slicer", ".vp.json", "3D Slicer 5.10 and newer", write_slicer, drawn_by_slicer},
      {"slicer-vp", "3D Slicer before 5.10", ".vp", "3D Slicer before 5.10", write_slicer_vp,
       drawn_by_slicer_vp},
      {"vtk-python", "VTK in Python", ".py", "a Python module for VTK, pyvista, Mayavi, trame",
       write_vtk_python, drawn_by_vtk_python},
      {"vtkjs", "vtk.js and VolView", ".json", "vtk.js and VolView", write_vtkjs, drawn_by_vtkjs},
      {"inviwo", "Inviwo", ".itf", "Inviwo's transfer function", write_inviwo, drawn_by_inviwo},
      {"csv", "CSV table", ".csv", "a table of equidistant values with colour, opacity and extinction",
       write_csv, drawn_by_table, table},
      {"npy", "NumPy table", ".npy", "a table for NumPy: scripts, napari, matplotlib, yt", write_npy,
       drawn_by_table, table},
      {"png", "PNG table", ".png", "a table as a picture of one row, 16 bits a channel", write_png,
       drawn_by_volume_table, table},
      {"1dt", "ImageVis3D and VisRTX", ".1dt", "a table for ImageVis3D and VisRTX", write_1dt,
       drawn_by_volume_table, table},
      {"f3d", "F3D", ".sh", "a table for F3D: two pictures and the command line", write_f3d, drawn_by_f3d,
       table},
      {"glsl", "GLSL source", ".glsl", "the function as source, and the peaks, for a renderer of your own",
       write_glsl, drawn_by_glsl},
  };
  return list;
}

const Exporter& find_exporter(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Exporter& exporter : exporters()) {
    if (exporter.name == name) return exporter;
    names.push_back(exporter.name);
  }
  throw Error(fmt::format("{}: no such export format; there are: {}{}", name, fmt::join(names, ", "),
                          did_you_mean(name, names)));
}

Preset ready_for_export(const Preset& preset, const std::optional<ExportVolume>& volume) {
  Preset ready = preset;
  TransferFunction& tf = ready.transfer_function;
  if (tf.points.empty()) throw Error("a transfer function without points cannot be exported");
  if (volume) {
    const glm::dvec3 s = volume->spacing;
    tf = resolve(tf, volume->range, std::min({s.x, s.y, s.z}));
  }
  if (tf.domain == Domain::normalized)
    throw Error(
        "the preset is normalized: its values are shares of a volume's range: open the volume, or name it "
        "(--volume)");
  if (tf.unit == LengthUnit::voxel)
    throw Error("the preset's unit distance is in voxels: open the volume, or name it (--volume)");
  return ready;
}

}  // namespace crest
