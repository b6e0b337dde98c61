#pragma once

#include "presets/exchange/exporters.h"

namespace crest {

// Each format's functions, as Exporter describes them, in files of their own: export_FORMAT.cpp.

Exported write_paraview(const ExportInput& input);
Preset drawn_by_paraview(const ExportInput& input);

Exported write_paraview_script(const ExportInput& input);
Preset drawn_by_paraview_script(const ExportInput& input);

Exported write_slicer(const ExportInput& input);
Preset drawn_by_slicer(const ExportInput& input);
Exported write_slicer_vp(const ExportInput& input);
Preset drawn_by_slicer_vp(const ExportInput& input);

Exported write_vtk_python(const ExportInput& input);
Preset drawn_by_vtk_python(const ExportInput& input);

Exported write_vtkjs(const ExportInput& input);
Preset drawn_by_vtkjs(const ExportInput& input);

Exported write_inviwo(const ExportInput& input);
Preset drawn_by_inviwo(const ExportInput& input);

Exported write_csv(const ExportInput& input);
Exported write_npy(const ExportInput& input);
Exported write_png(const ExportInput& input);
Exported write_1dt(const ExportInput& input);
Exported write_f3d(const ExportInput& input);
Preset drawn_by_table(const ExportInput& input);         // over the TF's own range
Preset drawn_by_volume_table(const ExportInput& input);  // over the volume's
Preset drawn_by_f3d(const ExportInput& input);

Exported write_glsl(const ExportInput& input);
Preset drawn_by_glsl(const ExportInput& input);

}  // namespace crest
