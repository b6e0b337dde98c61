#include <fmt/core.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstring>
#include <fstream>
#include <optional>

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

struct Close {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffHandle = std::unique_ptr<TIFF, Close>;

/// Of the byte order, and of the version: 42, or 43 of BigTIFF.
void require_mark(const fs::path& file) {
  using namespace std::string_view_literals;
  std::string head(4, '\0');
  std::ifstream(file, std::ios::binary).read(head.data(), std::streamsize(head.size()));
  constexpr std::string_view marks[] = {"II*\0"sv, "II+\0"sv, "MM\0*"sv, "MM\0+"sv};
  if (std::ranges::find(marks, head) == std::end(marks))
    throw Error(fmt::format("{}: not a TIFF file: it does not begin with II* or MM*", file.string()));
}

/// `fault` receives the library's messages, and `doubt` whether lengths are wrong, as long as the file is
/// open.
TiffHandle open(const fs::path& file, std::string& fault, bool& doubt) {
  require_mark(file);
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, keep_message, &fault);
  TIFFOpenOptionsSetWarningHandlerExtR(options, keep_doubt, &doubt);
  TiffHandle tiff(TIFFOpenExt(file.c_str(), "rm", options));
  TIFFOpenOptionsFree(options);
  if (!tiff) throw Error(fmt::format("{}: not an image that can be read: {}", file.string(), fault));
  return tiff;
}

template <class T>
T field(TIFF* tiff, std::uint32_t tag, T fallback) {
  T value = fallback;
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

/// The page that is current.
struct Page {
  std::uint32_t width = 0, height = 0;
  std::uint16_t channels = 1, bits = 8, kind = SAMPLEFORMAT_UINT, photometric = 0,
                planar = PLANARCONFIG_CONTIG;
  std::uint16_t compression = COMPRESSION_NONE;
};

Page page_of(TIFF* tiff) {
  Page page;
  page.width = field(tiff, TIFFTAG_IMAGEWIDTH, 0u);
  page.height = field(tiff, TIFFTAG_IMAGELENGTH, 0u);
  page.channels = field(tiff, TIFFTAG_SAMPLESPERPIXEL, page.channels);
  page.bits = field(tiff, TIFFTAG_BITSPERSAMPLE, page.bits);
  page.kind = field(tiff, TIFFTAG_SAMPLEFORMAT, page.kind);
  page.photometric = field(tiff, TIFFTAG_PHOTOMETRIC, page.photometric);
  page.planar = field(tiff, TIFFTAG_PLANARCONFIG, page.planar);
  page.compression = field(tiff, TIFFTAG_COMPRESSION, page.compression);
  return page;
}

std::optional<ScalarType> type_of(const Page& page) {
  using enum ScalarType;
  if (page.kind == SAMPLEFORMAT_IEEEFP) {
    if (page.bits == 16) return float16;
    if (page.bits == 32) return float32;
    if (page.bits == 64) return float64;
    return std::nullopt;
  }
  if (page.kind != SAMPLEFORMAT_UINT && page.kind != SAMPLEFORMAT_INT && page.kind != SAMPLEFORMAT_VOID)
    return std::nullopt;
  const bool is_signed = page.kind == SAMPLEFORMAT_INT;
  if (page.bits >= 1 && page.bits <= 8) return is_signed ? int8 : uint8;
  if (page.bits > 8 && page.bits <= 16) return is_signed ? int16 : uint16;
  if (page.bits == 32) return is_signed ? int32 : uint32;
  if (page.bits == 64) return is_signed ? int64 : uint64;
  return std::nullopt;
}

/// Numbers of any bits up to 16, the highest one first, to bytes or 16-bit ones.
void unpack_row(const std::byte* row, std::size_t count, const Page& page, std::size_t value_size,
                std::byte* out) {
  std::uint32_t held = 0;
  unsigned held_bits = 0;
  const std::uint32_t mask = (1u << page.bits) - 1, sign = 1u << (page.bits - 1);
  for (std::size_t i = 0; i < count; ++i) {
    while (held_bits < page.bits) held = held << 8 | std::to_integer<std::uint32_t>(*row++), held_bits += 8;
    std::uint32_t value = held >> (held_bits -= page.bits) & mask;
    if (page.kind == SAMPLEFORMAT_INT && (value & sign) != 0) value |= ~mask;
    std::memcpy(out + i * value_size, &value, value_size);  // little-endian machines
  }
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

struct Pages {
  std::size_t count = 0;
  std::vector<std::size_t> whole;  ///< neither smaller copies of others nor masks
};
/// All pages of a file that was just opened: to the library one that is not there, as the file was cut off,
/// is the end.
Pages walk_pages(const fs::path& file, TIFF* tiff, std::string& fault) {
  Pages pages;
  for (;; ++pages.count) {
    const auto kind = field(tiff, TIFFTAG_SUBFILETYPE, 0u);
    if ((kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) == 0) pages.whole.push_back(pages.count);
    if (TIFFLastDirectory(tiff) != 0) break;
    fault.clear();
    if (TIFFReadDirectory(tiff) != 1) {
      throw Error(page_fault(file, pages.count + 1,
                             fault.empty() ? "it is damaged, or beyond the file's end" : fault));
    }
  }
  ++pages.count;
  if (!fields_are_whole(file, tiff))
    throw Error(
        page_fault(file, pages.count - 1, "the file ends before it says whether another page follows"));
  return pages;
}

class TiffFile : public PageFile {
 public:
  explicit TiffFile(const fs::path& file)
      : file_(file), bytes_(fs::file_size(file)), tiff_(open(file, fault_, doubt_)) {}

  std::size_t pages() override {
    if (pages_ == 0) {
      std::string fault;
      bool doubt = false;
      pages_ = walk_pages(file_, open(file_, fault, doubt).get(), fault).count;
    }
    return pages_;
  }

  /// Where the first page, the only one, may have others behind its pixels.
  std::optional<TiffStack> stack() {
    const Page page = go_to(0);
    const char* text = nullptr;
    const bool has_text = TIFFGetField(tiff_.get(), TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text;
    const std::size_t images = has_text ? imagej_images(text) : 1;
    const auto type = type_of(page);
    const bool is_plain = page.compression == COMPRESSION_NONE && type && page.bits == 8 * size_of(*type) &&
                          page.planar == PLANARCONFIG_CONTIG && TIFFIsTiled(tiff_.get()) == 0;
    if (images < 2 || !is_plain || pages() > 1) return std::nullopt;
    return TiffStack{images, TIFFGetStrileOffset(tiff_.get(), 0),
                     TIFFIsBigEndian(tiff_.get()) != 0 ? std::endian::big : std::endian::little};
  }

  PageFormat format(std::size_t number) override {
    const Page page = go_to(number);
    const auto type = type_of(page);
    if (!type) fail(number, fmt::format("its pixels have {} bits of a kind that is not read", page.bits));
    if (page.photometric == PHOTOMETRIC_YCBCR && page.compression != COMPRESSION_JPEG)
      fail(number, "pixels as YCbCr are not read");
    PageFormat format{page.width, page.height, page.channels, *type, false, ""};
    format.is_colour = page.photometric == PHOTOMETRIC_RGB || page.photometric == PHOTOMETRIC_YCBCR;
    if (page.photometric == PHOTOMETRIC_MINISWHITE)
      format.note = "0 is shown white by other programs (MINISWHITE); values are kept";
    if (page.photometric == PHOTOMETRIC_PALETTE) format.note = "values are numbers of colours in its palette";
    constexpr std::uint64_t longest = std::uint64_t(1) << 24, greatest_inflation = std::uint64_t(1) << 16;
    if (field(tiff_.get(), TIFFTAG_IMAGEDEPTH, 1u) > 1) fail(number, "a page with a depth is not read");
    if (format.width == 0 || format.height == 0 || format.channels == 0) fail(number, "it has no pixels");
    if (format.width > longest || format.height > longest || format.channels > 1024 ||
        format.bytes() / greatest_inflation > bytes_)
      fail(number, fmt::format("it promises {}x{} pixels, and the file has {} bytes", page.width, page.height,
                               bytes_));
    return format;
  }

  void read(std::size_t number, std::span<std::byte> out) override {
    const PageFormat as = format(number);
    const Page page = page_of(tiff_.get());
    if (doubt_) fail(number, "its data is shorter than it promises");
    if (page.photometric == PHOTOMETRIC_YCBCR)
      TIFFSetField(tiff_.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    const bool tiled = TIFFIsTiled(tiff_.get()) != 0;
    const bool separate = page.planar == PLANARCONFIG_SEPARATE && page.channels > 1;
    const std::uint32_t wide = tiled ? field(tiff_.get(), TIFFTAG_TILEWIDTH, 0u) : page.width;
    const std::uint32_t high =
        tiled ? field(tiff_.get(), TIFFTAG_TILELENGTH, 0u)
              : std::min(field(tiff_.get(), TIFFTAG_ROWSPERSTRIP, page.height), page.height);
    if (wide == 0 || high == 0) fail(number, "its parts have no pixels");
    const std::size_t together = separate ? 1 : page.channels;
    const std::size_t row_bytes = (std::size_t(wide) * together * page.bits + 7) / 8;
    if (row_bytes / 65536 * high > bytes_) fail(number, "its parts are longer than the file can hold");
    std::vector<std::byte> part(row_bytes * high);
    std::uint32_t index = 0;
    for (std::size_t plane = 0; plane < (separate ? page.channels : 1u); ++plane) {
      for (std::uint32_t y = 0; y < page.height; y += high) {
        for (std::uint32_t x = 0; x < page.width; x += wide, ++index) {
          const std::uint32_t rows = std::min(high, page.height - y),
                              columns = std::min(wide, page.width - x);
          const std::size_t promised = row_bytes * (tiled ? high : rows);
          fault_.clear();
          const tmsize_t got =
              tiled ? TIFFReadEncodedTile(tiff_.get(), index, part.data(), tmsize_t(promised))
                    : TIFFReadEncodedStrip(tiff_.get(), index, part.data(), tmsize_t(promised));
          if (got < 0 || std::size_t(got) < promised || !fault_.empty())
            fail(number, "its data ends early, or is damaged");
          place(part, row_bytes, page, as, {x, y, columns, rows}, plane, separate, out);
        }
      }
    }
  }

 private:
  struct Box {
    std::uint32_t x, y, columns, rows;
  };

  /// A part's pixels at their place; of separate planes, those of one channel.
  static void place(const std::vector<std::byte>& part, std::size_t row_bytes, const Page& page,
                    const PageFormat& as, Box box, std::size_t plane, bool separate,
                    std::span<std::byte> out) {
    const std::size_t size = size_of(as.type), together = separate ? 1 : as.channels;
    const std::size_t count = box.columns * together;
    std::vector<std::byte> row(count * size);
    for (std::uint32_t r = 0; r < box.rows; ++r) {
      const std::byte* from = part.data() + r * row_bytes;
      if (page.bits == 8 * size)
        std::memcpy(row.data(), from, row.size());
      else
        unpack_row(from, count, page, size, row.data());
      const std::size_t first = ((box.y + r) * as.width + box.x) * as.channels;
      if (!separate) {
        std::memcpy(out.data() + first * size, row.data(), row.size());
        continue;
      }
      for (std::size_t i = 0; i < count; ++i)
        std::memcpy(out.data() + (first + i * as.channels + plane) * size, row.data() + i * size, size);
    }
  }

  Page go_to(std::size_t number) {
    fault_.clear();
    if (current_ != number) doubt_ = false;
    if (current_ != number && TIFFSetDirectory(tiff_.get(), tdir_t(number)) != 1) fail(number, fault_);
    current_ = number;
    return page_of(tiff_.get());
  }
  [[noreturn]] void fail(std::size_t number, const std::string& what) const {
    throw Error(page_fault(file_, number, what.empty() ? "it is damaged" : what));
  }

  fs::path file_;
  std::uint64_t bytes_;
  std::string fault_;
  bool doubt_ = false;
  TiffHandle tiff_;
  std::size_t pages_ = 0, current_ = 0;
};

}  // namespace

std::unique_ptr<PageFile> open_tiff(const fs::path& file) {
  auto pages = std::make_unique<TiffFile>(file);
  const auto stack = pages->stack();
  return stack ? open_imagej_stack(file, std::move(pages), *stack) : std::move(pages);
}

TiffDescription describe_tiff(const fs::path& file) {
  std::string fault;
  bool doubt = false;
  const TiffHandle tiff = open(file, fault, doubt);
  TiffDescription description;
  const char* text = nullptr;
  if (TIFFGetField(tiff.get(), TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text) description.text = text;
  float x = 0, y = 0;
  if (TIFFGetField(tiff.get(), TIFFTAG_XRESOLUTION, &x) == 1) description.pixels_per_unit_x = double(x);
  if (TIFFGetField(tiff.get(), TIFFTAG_YRESOLUTION, &y) == 1) description.pixels_per_unit_y = double(y);
  description.whole_pages = walk_pages(file, tiff.get(), fault).whole;
  return description;
}

}  // namespace crest
