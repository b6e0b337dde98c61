#include "render/files/file_modules.h"
#include "render/readers/readers.h"

namespace crest {
namespace {

Volume read(FileForm form, const FileRequest& request) {
  return form == FileForm::image_pages ? read_image_pages(request) : read_image_folder(request);
}

constexpr VolumeModule module{read};

}  // namespace
}  // namespace crest

extern "C" __attribute__((visibility("default"))) const crest::VolumeModule* crest_page_module() {
  return &crest::module;
}
