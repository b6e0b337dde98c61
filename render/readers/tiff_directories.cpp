#include "render/readers/tiff_directories.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <fstream>
#include <string_view>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/binary_fields.h"
#include "render/readers/page_file.h"
#include "render/readers/tiff_file.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

int keep_message(TIFF*, void* kept, const char*, const char* format, va_list arguments) {
  char text[512];
  std::vsnprintf(text, sizeof text, format, arguments);
  *static_cast<std::string*>(kept) = one_line(text);
  return 1;
}
/// Lengths that are too short are a warning to the library, which then takes what follows the data for
/// pixels.
int keep_doubt(TIFF*, void* kept, const char*, const char* format, va_list) {
  if (std::string_view(format).starts_with("Bogus")) *static_cast<bool*>(kept) = true;
  return 1;
}

/// Of the byte order, and of the version: 42, or 43 of BigTIFF.
void require_mark(const fs::path& file) {
  using namespace std::string_view_literals;
  std::string head(4, '\0');
  std::ifstream(file, std::ios::binary).read(head.data(), std::streamsize(head.size()));
  constexpr std::string_view marks[] = {"II*\0"sv, "II+\0"sv, "MM\0*"sv, "MM\0+"sv};
  if (std::ranges::find(marks, head) == std::end(marks))
    throw Error(fmt::format("{}: not a TIFF file: it does not begin with II* or MM*", file.string()));
}

/// Whether the current page's fields, and the place of the next page behind them, are in the file: to the
/// library a place that is cut off says that no page follows.
bool fields_are_whole(const fs::path& file, TIFF* tiff) {
  std::ifstream stream(file, std::ios::binary);
  const bool big = TIFFIsBigTIFF(tiff) != 0;
  std::string count(big ? 8 : 2, '\0');
  const std::uint64_t at = TIFFCurrentDirOffset(tiff);
  stream.seekg(std::streamoff(at));
  stream.read(count.data(), std::streamsize(count.size()));
  const BinaryFields fields{count, TIFFIsByteSwapped(tiff) != 0};
  const std::uint64_t entries = big ? fields.at<std::uint64_t>(0) : fields.at<std::uint16_t>(0);
  return stream && at + (big ? 8 + 20 * entries + 8 : 2 + 12 * entries + 4) <= fs::file_size(file);
}

}  // namespace

TiffHandle::TiffHandle(const fs::path& file) {
  require_mark(file);
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, keep_message, &fault);
  TIFFOpenOptionsSetWarningHandlerExtR(options, keep_doubt, &doubt);
  tiff.reset(TIFFOpenExt(file.c_str(), "rm", options));
  TIFFOpenOptionsFree(options);
  if (!tiff) throw Error(fmt::format("{}: not an image that can be read: {}", file.string(), fault));
}

TiffPages walk_pages(const fs::path& file, TiffHandle& handle) {
  TIFF* const tiff = handle.tiff.get();
  TiffPages pages;
  for (;;) {
    const auto kind = tiff_field(tiff, TIFFTAG_SUBFILETYPE, 0u);
    if ((kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) == 0) pages.whole.push_back(pages.offsets.size());
    pages.offsets.push_back(TIFFCurrentDirOffset(tiff));
    if (TIFFLastDirectory(tiff) != 0) break;
    handle.fault.clear();
    if (TIFFReadDirectory(tiff) != 1)
      throw Error(
          page_fault(file, pages.offsets.size(),
                     handle.fault.empty() ? "it is damaged, or beyond the file's end" : handle.fault));
  }
  if (!fields_are_whole(file, tiff))
    throw Error(page_fault(file, pages.offsets.size() - 1,
                           "the file ends before it says whether another page follows"));
  return pages;
}

TiffDescription describe_tiff(const fs::path& file) {
  TiffHandle handle(file);
  TIFF* const tiff = handle.tiff.get();
  TiffDescription description;
  const char* text = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text) description.text = text;
  float x = 0, y = 0;
  if (TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &x) == 1) description.pixels_per_unit_x = double(x);
  if (TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &y) == 1) description.pixels_per_unit_y = double(y);
  description.in_centimetres =
      tiff_field(tiff, TIFFTAG_RESOLUTIONUNIT, std::uint16_t(RESUNIT_NONE)) == RESUNIT_CENTIMETER;
  description.whole_pages = walk_pages(file, handle).whole;
  return description;
}

}  // namespace crest
