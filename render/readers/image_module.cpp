#include <OpenImageIO/imageio.h>

#include "render/files/file_modules.h"
#include "render/readers/image_files.h"
#include "render/readers/page_file.h"

namespace crest {
namespace {

constexpr ImageModule module{open_other_image, preset_in_picture_file, read_image_file, encode_rgb8,
                             encode_rgba32f};

}  // namespace
}  // namespace crest

extern "C" __attribute__((visibility("default"))) const crest::ImageModule* crest_image_module() {
  constexpr int threads = 4;  // each takes address space, which a reader has little of
  OIIO::attribute("threads", threads);
  OIIO::attribute("exr_threads", threads);
  return &crest::module;
}
