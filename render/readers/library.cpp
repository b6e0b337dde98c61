#include "render/files/file_library.h"
#include "render/readers/image_files.h"
#include "render/readers/readers.h"

namespace crest {
namespace {

Volume read_volume(FileForm form, const FileRequest& request) {
  switch (form) {
    case FileForm::nrrd:
      return read_nrrd(request);
    case FileForm::metaimage:
      return read_metaimage(request);
    case FileForm::nifti:
      return read_nifti(request);
    case FileForm::mrc:
      return read_mrc(request);
    case FileForm::vtk:
      return read_vtk(request);
    case FileForm::vti:
      return read_vti(request);
    case FileForm::npy:
      return read_npy(request);
    case FileForm::dicom_file:
      return read_dicom_file(request);
    case FileForm::dicom_series:
      return read_dicom_series(request);
    case FileForm::image_pages:
      return read_image_pages(request);
    case FileForm::image_folder:
      return read_image_folder(request);
  }
  return {};
}

constexpr FileLibrary library{
    read_volume, has_dicom, has_images, encode_rgb8, encode_rgba32f, preset_in_picture_file, read_image_file};

}  // namespace
}  // namespace crest

extern "C" __attribute__((visibility("default"))) const crest::FileLibrary* crest_file_library() {
  return &crest::library;
}
