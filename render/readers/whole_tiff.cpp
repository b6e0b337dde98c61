#include <fmt/core.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/whole_images.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// What libtiff tells of a file: its last error, and whether it did not believe how long a page's data is
/// said to be.
struct Told {
  std::string error;
  bool doubts_lengths = false;
};

std::string text_of(const char* format, va_list arguments) {
  char text[256];
  std::vsnprintf(text, sizeof text, format, arguments);
  return one_line(text);
}

int keep_error(TIFF*, void* told, const char*, const char* format, va_list arguments) {
  static_cast<Told*>(told)->error = text_of(format, arguments);
  return 1;
}

int keep_warning(TIFF*, void* told, const char*, const char* format, va_list arguments) {
  const std::string text = text_of(format, arguments);
  if (text.starts_with("Bogus") && text.find("ByteCounts") != std::string::npos)
    static_cast<Told*>(told)->doubts_lengths = true;
  return 1;
}

using File = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

File open(const fs::path& file, Told& told) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_error, &told);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), keep_warning, &told);
  return {TIFFOpenExt(file.c_str(), "r", options.get()), TIFFClose};
}

/// How much one byte of it may become.
std::uint64_t greatest_expansion(std::uint16_t compression) {
  switch (compression) {
    case COMPRESSION_NONE:
      return 1;
    case COMPRESSION_PACKBITS:
      return 64;
    case COMPRESSION_LZW:
      return 4096;
    case COMPRESSION_ADOBE_DEFLATE:
    case COMPRESSION_DEFLATE:
      return 1032;
    default:
      return 1 << 16;  // a white line of a fax is one bit
  }
}

template <class T>
T field(TIFF* tiff, std::uint32_t tag, T fallback) {
  T value = fallback;
  return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 ? value : fallback;
}

/// The open file's page, piece by piece.
class Page {
 public:
  Page(TIFF* tiff, std::string name, Told& told) : tiff_(tiff), name_(std::move(name)), told_(told) {}

  void require_whole() {
    // libtiff would take what follows in the file in its place.
    if (told_.doubts_lengths) fail("its data is shorter than its pixels");
    const auto compression = field<std::uint16_t>(tiff_, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    if (compression == COMPRESSION_OJPEG) return;  // of old scanners: it has no strips of its own
    const bool tiled = TIFFIsTiled(tiff_) != 0;
    const std::uint32_t pieces = tiled ? TIFFNumberOfTiles(tiff_) : TIFFNumberOfStrips(tiff_);
    for (std::uint32_t i = 0; i < pieces; ++i) {
      const tmsize_t size = tiled ? TIFFTileSize(tiff_) : TIFFVStripSize(tiff_, rows_of(i));
      const std::uint64_t held = TIFFGetStrileByteCount(tiff_, i);
      if (size <= 0 || std::uint64_t(size) / greatest_expansion(compression) > held)
        fail(fmt::format("{} bytes of pixels in {} bytes of the file", size, held));
      decoded_.resize(std::size_t(size));
      const tmsize_t got = tiled ? TIFFReadEncodedTile(tiff_, i, decoded_.data(), size)
                                 : TIFFReadEncodedStrip(tiff_, i, decoded_.data(), size);
      if (got != size) fail(fmt::format("its data ends early, or is damaged ({})", told_.error));
    }
  }

 private:
  /// The last strip of each plane may be shorter.
  std::uint32_t rows_of(std::uint32_t strip) const {
    const auto height = field<std::uint32_t>(tiff_, TIFFTAG_IMAGELENGTH, 0);
    const std::uint32_t rows = std::clamp<std::uint32_t>(
        field<std::uint32_t>(tiff_, TIFFTAG_ROWSPERSTRIP, height), 1, std::max(height, 1u));
    const std::uint32_t strips = height / rows + (height % rows != 0);
    const std::uint32_t first = strips == 0 ? 0 : strip % strips * rows;
    return std::min(rows, height - first);
  }
  [[noreturn]] void fail(const std::string& why) const { throw Error(fmt::format("{}: {}", name_, why)); }

  TIFF* tiff_;
  std::string name_;
  Told& told_;
  std::vector<char> decoded_;
};

}  // namespace

void require_whole_tiff(const fs::path& file) {
  Told told;
  const File tiff = open(file, told);
  if (!tiff) throw Error(fmt::format("{}: not a TIFF file that can be read: {}", file.string(), told.error));
  int number = 0;
  do {
    Page page(tiff.get(), fmt::format("{}: page {}", file.string(), ++number), told);
    page.require_whole();
  } while (TIFFReadDirectory(tiff.get()) == 1);
}

}  // namespace crest
