#include "render/readers/page_file.h"

#include "render/files/file_modules.h"
#include "render/files/file_request.h"
#include "render/files/kinds.h"

namespace crest {

bool is_tiff(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  return extension == ".tif" || extension == ".tiff";
}

std::unique_ptr<PageFile> open_pages(const std::filesystem::path& file) {
  if (!is_plain_image(file)) return image_module().open_pages(file);
  const std::string extension = extension_of(file);
  if (is_tiff(file)) return open_tiff(file);
  if (extension == ".png") return open_png(file);
  if (extension == ".jpg" || extension == ".jpeg") return open_jpeg(file);
  return open_pnm(file);
}

}  // namespace crest
