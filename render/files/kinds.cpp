#include "render/files/kinds.h"

#include <algorithm>
#include <fstream>
#include <string>

#include "render/files/file_request.h"

namespace crest {

namespace fs = std::filesystem;

namespace {

/// An element of group 2 or 8 at its very start, and a later one of that group behind it, as files have that
/// were written without a head.
bool begins_with_elements(std::string_view head) {
  constexpr std::string_view types = "CS DA LO SH TM UI UL";
  constexpr unsigned char highest_member = 0x18, longest = 64;
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(head[at]); };
  if ((byte(0) != 2 && byte(0) != 8) || byte(1) != 0 || byte(2) > highest_member || byte(3) != 0)
    return false;
  const bool has_type = types.find(head.substr(4, 2)) != std::string_view::npos;
  if (has_type ? byte(7) != 0 : byte(5) != 0 || byte(6) != 0 || byte(7) != 0) return false;
  const unsigned char length = byte(has_type ? 6 : 4);
  if (length > longest) return false;
  const std::size_t next = 8u + length;
  return byte(next) == byte(0) && byte(next + 1) == 0 && (byte(next + 2) > byte(2) || byte(next + 3) > 0);
}

}  // namespace

bool is_dicom(const fs::path& path) {
  constexpr std::size_t preamble = 128;
  if (!fs::is_regular_file(path)) return false;
  std::string head(preamble + 4, '\0');
  std::ifstream(path, std::ios::binary).read(head.data(), std::streamsize(head.size()));
  return head.ends_with("DICM") || begins_with_elements(head);
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
