#include "presets/error.h"
#include "render/readers/headers.h"
#include "render/readers/readers.h"
#include "render/readers/voxel_reader.h"

namespace crest {

Volume read_voxel_file(FileForm form, const FileRequest& request) {
  const auto& path = request.path;
  switch (form) {
    case FileForm::nrrd:
      return read_voxels(request, read_nrrd_header(path));
    case FileForm::metaimage:
      return read_voxels(request, read_metaimage_header(path));
    case FileForm::nifti:
      return read_voxels(request, read_nifti_header(path));
    case FileForm::mrc:
      return read_voxels(request, read_mrc_header(path));
    case FileForm::npy:
      return read_voxels(request, read_npy_header(path));
    case FileForm::vtk:
      return read_vtk(request);
    case FileForm::vti:
      return read_vti(request);
    case FileForm::pvti:
      return read_pvti(request);
    default:
      throw Error(request.name() + ": not a file of voxels");
  }
}

}  // namespace crest
