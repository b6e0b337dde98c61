// Netpbm's formats P1 to P6: OpenImageIO scales their values to a type's whole range.
#include <fmt/core.h>

#include <cctype>
#include <fstream>

#include "presets/error.h"
#include "render/readers/page_file.h"
#include "render/readers/text_voxels.h"
#include "render/volume/convert.h"

namespace crest {
namespace {

class PnmFile : public PageFile {
 public:
  explicit PnmFile(const std::filesystem::path& file) : file_(file) {
    std::ifstream stream(file, std::ios::binary);
    if (stream.get() != 'P') fail("not a Netpbm image");
    kind_ = stream.get() - '0';
    if (kind_ < 1 || kind_ > 6) fail("not a Netpbm image of kind P1 to P6");
    format_.width = number(stream, 1 << 24);
    format_.height = number(stream, 1 << 24);
    const std::uint64_t greatest = is_bitmap() ? 1 : number(stream, 65535);
    format_.channels = kind_ % 3 == 0 ? 3 : 1;
    format_.is_colour = format_.channels == 3;
    format_.type = greatest > 255 ? ScalarType::uint16 : ScalarType::uint8;
    if (is_bitmap()) format_.note = "0 is shown white by other programs; values are kept";
    data_ = std::uint64_t(stream.tellg());
    const std::uint64_t held = std::filesystem::file_size(file) - data_;
    const std::uint64_t promised = kind_ == 4  ? (format_.width + 7) / 8 * format_.height
                                   : kind_ > 4 ? format_.bytes()
                                               : format_.width * format_.height;
    if (held < promised)
      fail(fmt::format("its header promises {} bytes of pixels, and it has {}", promised, held));
    if (kind_ > 3) refuse_another(stream, promised);
  }
  std::size_t pages() override { return 1; }
  PageFormat format(std::size_t) override { return format_; }
  void read(std::size_t, std::span<std::byte> out) override {
    std::ifstream stream(file_, std::ios::binary);
    stream.seekg(std::streamoff(data_));
    if (kind_ == 4) return read_bits(stream, out);
    if (kind_ == 1) return read_digits(stream, out);
    if (kind_ < 4) {
      WordStream words(stream);
      return read_numbers(file_.string(), words, format_.type, out);
    }
    stream.read(reinterpret_cast<char*>(out.data()), std::streamsize(out.size()));
    if (std::endian::native == std::endian::little) swap_bytes(out, size_of(format_.type));
  }

 private:
  bool is_bitmap() const { return kind_ % 3 == 1; }
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(fmt::format("{}: not an image that can be read: {}", file_.string(), what));
  }
  /// Other programs write several images into a file.
  void refuse_another(std::istream& stream, std::uint64_t promised) const {
    stream.seekg(std::streamoff(data_ + promised));
    if ((stream >> std::ws).get() == 'P' && std::isdigit(stream.peek()))
      fail("it holds several images, and one a file is read");
  }
  /// The header's next number, behind comments; takes the one blank after it too.
  std::uint64_t number(std::istream& stream, std::uint64_t most) const {
    int c = stream.get();
    while (c == '#' || std::isspace(c)) {
      if (c == '#')
        while (c != '\n' && c != EOF) c = stream.get();
      c = stream.get();
    }
    std::uint64_t value = 0;
    for (; std::isdigit(c) && value <= most; c = stream.get()) value = value * 10 + std::uint64_t(c - '0');
    if (value == 0 || value > most || !std::isspace(c)) fail("its header is damaged");
    return value;
  }
  void read_bits(std::istream& stream, std::span<std::byte> out) const {
    std::string row((format_.width + 7) / 8, '\0');
    for (std::uint64_t y = 0; y < format_.height; ++y) {
      stream.read(row.data(), std::streamsize(row.size()));
      for (std::uint64_t x = 0; x < format_.width; ++x)
        out[y * format_.width + x] = std::byte(static_cast<unsigned char>(row[x / 8]) >> (7 - x % 8) & 1);
    }
  }
  /// Digits that no blank need part.
  void read_digits(std::istream& stream, std::span<std::byte> out) const {
    for (std::byte& value : out) {
      int c = stream.get();
      while (std::isspace(c)) c = stream.get();
      if (c != '0' && c != '1') throw Error(page_fault(file_, 0, "its pixels are not all 0 or 1"));
      value = std::byte(c - '0');
    }
  }

  std::filesystem::path file_;
  int kind_ = 0;
  PageFormat format_;
  std::uint64_t data_ = 0;
};

}  // namespace

std::unique_ptr<PageFile> open_pnm(const std::filesystem::path& file) {
  return std::make_unique<PnmFile>(file);
}

}  // namespace crest
