#include "presets/error.h"
#include "render/files/file_modules.h"
#include "render/readers/readers.h"

namespace crest {
namespace {

Volume read(FileForm form, const FileRequest& request) {
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
    case FileForm::dicom_file:
      return read_dicom_file(request);
    case FileForm::dicom_series:
      return read_dicom_series(request);
    default:
      throw Error(request.name() + ": not a volume's file");
  }
}

constexpr VolumeModule module{read};

}  // namespace
}  // namespace crest

extern "C" __attribute__((visibility("default"))) const crest::VolumeModule* crest_volume_module() {
  return &crest::module;
}
