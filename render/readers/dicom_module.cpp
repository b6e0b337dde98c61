#include "render/files/file_modules.h"
#include "render/readers/readers.h"

namespace crest {
namespace {

Volume read(FileForm form, const FileRequest& request) {
  return form == FileForm::dicom_file ? read_dicom_file(request) : read_dicom_series(request);
}

constexpr VolumeModule module{read};

}  // namespace
}  // namespace crest

extern "C" __attribute__((visibility("default"))) const crest::VolumeModule* crest_dicom_module() {
  return &crest::module;
}
