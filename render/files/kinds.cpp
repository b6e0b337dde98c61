#include "render/files/kinds.h"

#include <algorithm>
#include <fstream>
#include <string>

#include "render/files/file_request.h"

namespace crest {

namespace fs = std::filesystem;

namespace {

/// An element of group 2 or 8 at its very start, as files have that were written without a head: its type, or
/// a length that such an element has.
bool begins_with_element(std::string_view head) {
  constexpr std::string_view types = "CS DA LO SH TM UI UL";
  constexpr unsigned char highest_member = 0x18, longest = 64;
  if ((head[0] != 2 && head[0] != 8) || head[1] != 0 || head[3] != 0) return false;
  if (static_cast<unsigned char>(head[2]) > highest_member) return false;
  if (types.find(head.substr(4, 2)) != std::string_view::npos) return true;
  return head[0] == 8 && static_cast<unsigned char>(head[4]) <= longest && head[4] % 2 == 0 &&
         head.substr(5, 3) == std::string_view("\0\0", 3);
}

}  // namespace

bool is_dicom(const fs::path& path) {
  constexpr std::size_t preamble = 128;
  if (!fs::is_regular_file(path)) return false;
  std::string head(preamble + 4, '\0');
  std::ifstream(path, std::ios::binary).read(head.data(), std::streamsize(head.size()));
  return head.ends_with("DICM") || begins_with_element(head);
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
