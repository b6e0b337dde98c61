#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "presets/error.h"
#include "render/readers/page_file.h"
#include "render/readers/tiff_directories.h"
#include "render/readers/tiff_file.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// The page that is current.
struct Page {
  std::uint32_t width = 0, height = 0;
  std::uint16_t channels = 1, bits = 8, kind = SAMPLEFORMAT_UINT, photometric = 0,
                planar = PLANARCONFIG_CONTIG;
  std::uint16_t compression = COMPRESSION_NONE;
};

Page page_of(TIFF* tiff) {
  Page page;
  page.width = tiff_field(tiff, TIFFTAG_IMAGEWIDTH, 0u);
  page.height = tiff_field(tiff, TIFFTAG_IMAGELENGTH, 0u);
  page.channels = tiff_field(tiff, TIFFTAG_SAMPLESPERPIXEL, page.channels);
  page.bits = tiff_field(tiff, TIFFTAG_BITSPERSAMPLE, page.bits);
  page.kind = tiff_field(tiff, TIFFTAG_SAMPLEFORMAT, page.kind);
  page.photometric = tiff_field(tiff, TIFFTAG_PHOTOMETRIC, page.photometric);
  page.planar = tiff_field(tiff, TIFFTAG_PLANARCONFIG, page.planar);
  page.compression = tiff_field(tiff, TIFFTAG_COMPRESSION, page.compression);
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

/// How a page's pixels are cut into parts that are stored on their own: row by row, and plane by plane.
struct Parts {
  bool tiled = false;                ///< else strips of whole rows, the last of which may have fewer
  std::uint32_t wide = 0, high = 0;  ///< pixels of one; tiles stand out over the page
  std::uint64_t across = 0, down = 0, planes = 1;  ///< parts: none across or down where they have no pixels
  std::size_t channels = 1;                        ///< of a pixel in a part: 1 where each has its plane
  std::size_t row_bytes = 0;

  std::uint64_t count() const { return across * down * planes; }
};

Parts parts_of(TIFF* tiff, const Page& page) {
  Parts parts;
  parts.tiled = TIFFIsTiled(tiff) != 0;
  parts.wide = parts.tiled ? tiff_field(tiff, TIFFTAG_TILEWIDTH, 0u) : page.width;
  parts.high = parts.tiled ? tiff_field(tiff, TIFFTAG_TILELENGTH, 0u)
                           : std::min(tiff_field(tiff, TIFFTAG_ROWSPERSTRIP, page.height), page.height);
  if (parts.wide > 0) parts.across = (page.width - 1) / parts.wide + 1;
  if (parts.high > 0) parts.down = (page.height - 1) / parts.high + 1;
  if (page.planar == PLANARCONFIG_SEPARATE)
    parts.planes = page.channels;
  else
    parts.channels = page.channels;
  parts.row_bytes = (std::size_t(parts.wide) * parts.channels * page.bits + 7) / 8;
  return parts;
}

/// The pixels of a page that are in one part.
struct Box {
  std::uint32_t x = 0, y = 0, columns = 0, rows = 0;
  std::size_t plane = 0;
};

Box box_of(const Parts& parts, const Page& page, std::uint64_t number) {
  const auto x = std::uint32_t(number % parts.across * parts.wide),
             y = std::uint32_t(number / parts.across % parts.down * parts.high);
  return {x, y, std::min(parts.wide, page.width - x), std::min(parts.high, page.height - y),
          std::size_t(number / parts.across / parts.down)};
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

/// A part's pixels at their place in the page.
void put_part(const std::vector<std::byte>& part, const Parts& parts, const Page& page, const Box& box,
              std::size_t size, std::span<std::byte> out) {
  const std::size_t count = box.columns * parts.channels;
  std::vector<std::byte> row(count * size);
  for (std::uint32_t r = 0; r < box.rows; ++r) {
    const std::byte* from = part.data() + r * parts.row_bytes;
    if (page.bits == 8 * size)
      std::memcpy(row.data(), from, row.size());
    else
      unpack_row(from, count, page, size, row.data());
    const std::size_t first = (std::size_t(box.y + r) * page.width + box.x) * page.channels;
    if (parts.planes == 1) {
      std::memcpy(out.data() + first * size, row.data(), row.size());
      continue;
    }
    for (std::size_t i = 0; i < count; ++i)
      std::memcpy(out.data() + (first + i * page.channels + box.plane) * size, row.data() + i * size, size);
  }
}

class TiffFile : public PageFile {
 public:
  explicit TiffFile(const fs::path& file)
      : file_(file), bytes_(fs::file_size(file)), handle_(file), tiff_(handle_.tiff.get()) {}

  std::size_t pages() override { return offsets().size(); }

  /// Where the first page, the only one, may have others behind its pixels: ImageJ writes the directory
  /// before them.
  std::optional<TiffStack> stack() {
    const Page page = go_to(0);
    const char* text = nullptr;
    const bool has_text = TIFFGetField(tiff_, TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text;
    const std::size_t images = has_text ? imagej_images(text) : 1;
    const auto type = type_of(page);
    const bool is_plain = page.compression == COMPRESSION_NONE && type && page.bits == 8 * size_of(*type) &&
                          page.planar == PLANARCONFIG_CONTIG && TIFFIsTiled(tiff_) == 0;
    if (images < 2 || !is_plain || pages() > 1) return std::nullopt;
    const std::uint64_t begin = TIFFGetStrileOffset(tiff_, 0);
    if (begin < TIFFCurrentDirOffset(tiff_))
      return std::nullopt;  // a description that is left of another file
    return TiffStack{images, begin, TIFFIsBigEndian(tiff_) != 0 ? std::endian::big : std::endian::little};
  }

  PageFormat format(std::size_t number) override {
    const Page page = go_to(number);
    require_readable(number, page);
    PageFormat format{page.width, page.height, page.channels, *type_of(page), false, ""};
    require_possible(number, format);
    format.is_colour = page.photometric == PHOTOMETRIC_RGB || page.photometric == PHOTOMETRIC_YCBCR;
    if (page.photometric == PHOTOMETRIC_MINISWHITE)
      format.note = "0 is shown white by other programs (MINISWHITE); values are kept";
    if (page.photometric == PHOTOMETRIC_PALETTE) format.note = "values are numbers of colours in its palette";
    const auto orientation = tiff_field(tiff_, TIFFTAG_ORIENTATION, std::uint16_t(ORIENTATION_TOPLEFT));
    if (orientation != ORIENTATION_TOPLEFT)
      format.note += fmt::format(
          "{}other programs may show its images flipped or turned (orientation {}); rows "
          "are kept as they are stored",
          format.note.empty() ? "" : "; ", orientation);
    return format;
  }

  void read(std::size_t number, std::span<std::byte> out) override {
    const std::size_t value_size = size_of(format(number).type);
    const Page page = page_of(tiff_);
    if (handle_.doubt) fail(number, "its data is shorter than it promises");
    if (page.photometric == PHOTOMETRIC_YCBCR) TIFFSetField(tiff_, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    const Parts parts = parts_of(tiff_, page);
    if (parts.count() == 0) fail(number, "its parts have no pixels");
    if (parts.row_bytes / 65536 * parts.high > bytes_)
      fail(number, "its parts are longer than the file can hold");
    const auto read_part = parts.tiled ? TIFFReadEncodedTile : TIFFReadEncodedStrip;
    std::vector<std::byte> part(parts.row_bytes * parts.high);
    for (std::uint64_t i = 0; i < parts.count(); ++i) {
      const Box box = box_of(parts, page, i);
      const auto promised = tmsize_t(parts.row_bytes * (parts.tiled ? parts.high : box.rows));
      handle_.fault.clear();
      if (read_part(tiff_, std::uint32_t(i), part.data(), promised) < promised || !handle_.fault.empty())
        fail(number, "its data ends early, or is damaged");
      put_part(part, parts, page, box, value_size, out);
    }
  }

 private:
  void require_readable(std::size_t number, const Page& page) const {
    if (!type_of(page))
      fail(number, fmt::format("its pixels have {} bits of a kind that is not read", page.bits));
    if (page.photometric == PHOTOMETRIC_YCBCR && page.compression != COMPRESSION_JPEG)
      fail(number, "pixels as YCbCr are not read");
    if (TIFFIsCODECConfigured(page.compression) == 0)
      fail(number,
           fmt::format("its compression (number {}) is not read; save it with LZW or Deflate, or none",
                       page.compression));
    if (tiff_field(tiff_, TIFFTAG_IMAGEDEPTH, 1u) > 1) fail(number, "a page with a depth is not read");
  }
  /// What no file of this length holds is refused before memory is asked for.
  void require_possible(std::size_t number, const PageFormat& format) const {
    constexpr std::uint64_t longest = std::uint64_t(1) << 24, greatest_inflation = std::uint64_t(1) << 16;
    if (format.width == 0 || format.height == 0 || format.channels == 0) fail(number, "it has no pixels");
    if (format.width > longest || format.height > longest || format.channels > 1024 ||
        format.bytes() / greatest_inflation > bytes_)
      fail(number, fmt::format("it promises {}x{} pixels, and the file has {} bytes", format.width,
                               format.height, bytes_));
  }

  /// Of all pages' directories, by a walk in which this page stays the current one.
  const std::vector<std::uint64_t>& offsets() {
    if (offsets_.empty()) {
      TiffHandle walked(file_);
      offsets_ = walk_pages(file_, walked).offsets;
    }
    return offsets_;
  }

  /// Straight to the page's directory: by its number libtiff 4.5 would walk from the first page.
  Page go_to(std::size_t number) {
    if (current_ == number) return page_of(tiff_);
    if (number >= pages()) fail(number, "the file has no such page");
    current_.reset();
    handle_.fault.clear();
    handle_.doubt = false;
    if (TIFFSetSubDirectory(tiff_, offsets()[number]) != 1) fail(number, handle_.fault);
    current_ = number;
    return page_of(tiff_);
  }
  [[noreturn]] void fail(std::size_t number, const std::string& what) const {
    throw Error(page_fault(file_, number, what.empty() ? "it is damaged" : what));
  }

  fs::path file_;
  std::uint64_t bytes_;
  TiffHandle handle_;
  TIFF* tiff_;
  std::vector<std::uint64_t> offsets_;      ///< empty until they are asked for
  std::optional<std::size_t> current_ = 0;  ///< none after one could not be read
};

}  // namespace

std::unique_ptr<PageFile> open_tiff(const fs::path& file) {
  auto pages = std::make_unique<TiffFile>(file);
  const auto stack = pages->stack();
  return stack ? open_imagej_stack(file, std::move(pages), *stack) : std::move(pages);
}

}  // namespace crest
