#include "render/readers/headers.h"
#include "render/readers/readers.h"
#include "render/readers/voxel_reader.h"

namespace crest {

Volume read_nrrd(const FileRequest& request) { return read_voxels(request, read_nrrd_header(request.path)); }
Volume read_metaimage(const FileRequest& request) {
  return read_voxels(request, read_metaimage_header(request.path));
}
Volume read_nifti(const FileRequest& request) {
  return read_voxels(request, read_nifti_header(request.path));
}
Volume read_mrc(const FileRequest& request) { return read_voxels(request, read_mrc_header(request.path)); }
Volume read_npy(const FileRequest& request) { return read_voxels(request, read_npy_header(request.path)); }

}  // namespace crest
