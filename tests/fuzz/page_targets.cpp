// Images as the slices of a volume, by the code that the reader's program reads them with.
#include <zlib.h>

#include <algorithm>

#include "render/readers/page_file.h"
#include "render/readers/readers.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/target_list.h"
#include "tests/fuzz/volume_file.h"

namespace crest::fuzz {
namespace {

void read_pages(const std::string& path, std::unique_ptr<PageFile> (*open)(const std::filesystem::path&)) {
  constexpr std::uint64_t most_bytes = 1 << 22;
  const auto file = open(path);
  for (std::size_t page = 0; page < std::min<std::size_t>(file->pages(), 8); ++page) {
    const PageFormat format = file->format(page);
    require(format.width > 0 && format.height > 0 && format.channels > 0, "a page has pixels");
    if (format.bytes() > most_bytes) continue;
    std::vector<std::byte> bytes(format.bytes());
    file->read(page, bytes);
    require(file->format(page) == format, "a page is the same after it was read");
  }
}

/// The chunks of a PNG file with the checksums that they ought to have: what is changed in them is then
/// looked at.
std::string with_right_checksums(std::string file) {
  const auto byte = [&](std::size_t at) { return std::uint64_t(static_cast<unsigned char>(file[at])); };
  for (std::size_t at = 8; at + 12 <= file.size();) {
    const std::uint64_t length = byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3);
    if (length > file.size() - at - 12) break;
    const std::size_t end = at + 8 + std::size_t(length);
    const auto* typed = reinterpret_cast<const Bytef*>(file.data() + at + 4);
    const std::uint64_t sum = crc32(0, typed, uInt(length + 4));
    for (std::size_t i = 0; i < 4; ++i) file[end + i] = char(sum >> (24 - 8 * i) & 0xff);
    at = end + 4;
  }
  return file;
}

}  // namespace

void read_tiff(std::string_view input) {
  const std::string path = write_scratch("pages.tif", input);
  read_pages(path, open_tiff);
  read_volume(path, read_image_pages);
}
void read_png(std::string_view input) {
  read_pages(write_scratch("page.png", with_right_checksums(std::string(input))), open_png);
}
void read_pnm(std::string_view input) { read_pages(write_scratch("page.pnm", input), open_pnm); }

}  // namespace crest::fuzz
