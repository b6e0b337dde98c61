#include "render/files/kinds.h"

#include <algorithm>
#include <fstream>
#include <string>

#include "render/files/file_request.h"

namespace crest {

namespace fs = std::filesystem;

bool is_dicom(const fs::path& path) {
  constexpr std::size_t preamble = 128;
  if (!fs::is_regular_file(path)) return false;
  std::string head(preamble + 4, '\0');
  std::ifstream(path, std::ios::binary).read(head.data(), std::streamsize(head.size()));
  return head.ends_with("DICM");
}

bool is_image(const fs::path& path) {
  constexpr std::string_view others[] = {".bmp", ".exr", ".tga", ".jp2", ".webp"};
  return fs::is_regular_file(path) && !path.filename().string().starts_with('.') &&
         (is_plain_image(path) || std::ranges::find(others, extension_of(path)) != std::end(others));
}

bool is_plain_image(const fs::path& path) {
  constexpr std::string_view extensions[] = {".png", ".tif", ".tiff", ".jpg", ".jpeg",
                                             ".pgm", ".pbm", ".pnm",  ".ppm"};
  return std::ranges::find(extensions, extension_of(path)) != std::end(extensions);
}

}  // namespace crest
