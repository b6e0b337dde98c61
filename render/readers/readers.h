#pragma once

#include "render/files/file_modules.h"
#include "render/files/file_request.h"
#include "render/volume/volume.h"

namespace crest {

// Each fills the grid, the values, the file's type, the direction and the note; load_volume does the rest.

/// The forms that need no library but zlib and an XML parser: NRRD, MetaImage, NIfTI, MRC, NumPy and VTK's.
Volume read_voxel_file(FileForm form, const FileRequest& request);
Volume read_vtk(const FileRequest& request);
Volume read_vti(const FileRequest& request);
Volume read_pvti(const FileRequest& request);  ///< pieces in files of their own, named in this one
Volume read_dicom_file(const FileRequest& request);
Volume read_dicom_series(const FileRequest& request);  ///< of the folder's DICOM files
Volume read_image_pages(const FileRequest& request);   ///< of one file
Volume read_image_folder(const FileRequest& request);  ///< of the images in it, sorted by name

}  // namespace crest
