#pragma once

#include "render/files/file_request.h"
#include "render/volume/volume.h"

namespace crest {

// Each fills the grid, the values, the file's type, the direction and the note; load_volume does the rest.
Volume read_nrrd(const FileRequest& request);
Volume read_metaimage(const FileRequest& request);
Volume read_nifti(const FileRequest& request);
Volume read_mrc(const FileRequest& request);
Volume read_vtk(const FileRequest& request);
Volume read_vti(const FileRequest& request);
Volume read_npy(const FileRequest& request);
Volume read_dicom_file(const FileRequest& request);
Volume read_dicom_series(const FileRequest& request);  ///< of the folder's DICOM files
Volume read_image_pages(const FileRequest& request);   ///< of one file
Volume read_image_folder(const FileRequest& request);  ///< of the images in it, sorted by name

/// Whether the folder holds a DICOM file, or image files.
bool has_dicom(const std::filesystem::path& folder);
bool has_images(const std::filesystem::path& folder);

}  // namespace crest
