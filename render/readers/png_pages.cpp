#include <fmt/core.h>
#include <png.h>

#include <cstdio>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/page_file.h"

namespace crest {
namespace {

struct Fault {
  std::string text;
};
[[noreturn]] void throw_fault(png_structp, png_const_charp text) { throw Fault{text}; }
void drop_warning(png_structp, png_const_charp) {}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// An open PNG file whose header is read.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : file_(std::fopen(path.c_str(), "rb")) {
    if (!file_) throw Fault{"it cannot be opened"};
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, throw_fault, drop_warning);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) throw Fault{"libpng could not be started"};
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  void read_header() {
    png_init_io(png_, file_.get());
    png_read_info(png_, info_);
  }
  png_structp png() { return png_; }
  png_infop info() { return info_; }

 private:
  std::unique_ptr<std::FILE, Close> file_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

class PngFile : public PageFile {
 public:
  explicit PngFile(const std::filesystem::path& file) : file_(file) {
    try {
      Reader reader(file);
      reader.read_header();
      format_.width = png_get_image_width(reader.png(), reader.info());
      format_.height = png_get_image_height(reader.png(), reader.info());
      format_.channels = png_get_channels(reader.png(), reader.info());
      format_.is_colour = format_.channels >= 3;
      format_.type =
          png_get_bit_depth(reader.png(), reader.info()) == 16 ? ScalarType::uint16 : ScalarType::uint8;
      if (png_get_color_type(reader.png(), reader.info()) == PNG_COLOR_TYPE_PALETTE)
        format_.note = "values are numbers of colours in its palette";
    } catch (const Fault& fault) {
      throw Error(fmt::format("{}: not an image that can be read: {}", file.string(), one_line(fault.text)));
    }
  }
  std::size_t pages() override { return 1; }
  PageFormat format(std::size_t) override { return format_; }
  void read(std::size_t page, std::span<std::byte> out) override {
    try {
      Reader reader(file_);
      reader.read_header();
      png_set_packing(reader.png());  // a byte for numbers of 1, 2 or 4 bits: not scaled
      if (format_.type == ScalarType::uint16) png_set_swap(reader.png());  // little-endian machines
      png_set_interlace_handling(reader.png());
      png_read_update_info(reader.png(), reader.info());
      const std::size_t row = format_.bytes() / format_.height;
      if (png_get_rowbytes(reader.png(), reader.info()) != row) throw Fault{"its rows have another length"};
      std::vector<png_bytep> rows;
      for (std::size_t y = 0; y < format_.height; ++y)
        rows.push_back(reinterpret_cast<png_bytep>(out.data() + y * row));
      png_read_image(reader.png(), rows.data());
      png_read_end(reader.png(), nullptr);
    } catch (const Fault& fault) {
      throw Error(page_fault(file_, page, one_line(fault.text)));
    }
  }

 private:
  std::filesystem::path file_;
  PageFormat format_;
};

}  // namespace

std::unique_ptr<PageFile> open_png(const std::filesystem::path& file) {
  return std::make_unique<PngFile>(file);
}

}  // namespace crest
