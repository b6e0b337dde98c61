#include "render/readers/page_file.h"

#include <fmt/core.h>

#include "render/files/file_request.h"

namespace crest {

std::unique_ptr<PageFile> open_pages(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  if (extension == ".tif" || extension == ".tiff") return open_tiff(file);
  if (extension == ".png") return open_png(file);
  if (extension == ".pgm" || extension == ".ppm" || extension == ".pnm" || extension == ".pbm")
    return open_pnm(file);
  return open_other_image(file);
}

std::string page_fault(const std::filesystem::path& file, std::size_t page, const std::string& what) {
  return fmt::format("{}: page {} could not be read: {}", file.string(), page + 1, what);
}

}  // namespace crest
