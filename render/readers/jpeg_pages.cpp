#include <fmt/core.h>

#include <csetjmp>
#include <cstdio>
#include <memory>

#include <jpeglib.h>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/page_file.h"

namespace crest {
namespace {

/// libjpeg's way to end: its errors must not return.
struct Faults {
  jpeg_error_mgr calls;  // first: libjpeg knows it by this address
  std::jmp_buf end;
  char* why;  ///< the first thing it warned of, or its error
};

void keep_first(j_common_ptr jpeg) {
  if (jpeg->err->num_warnings++ == 0)
    jpeg->err->format_message(jpeg, reinterpret_cast<Faults*>(jpeg->err)->why);
}

void keep_warning(j_common_ptr jpeg, int level) {
  if (level < 0) keep_first(jpeg);
}

[[noreturn]] void leave(j_common_ptr jpeg) {
  keep_first(jpeg);
  std::longjmp(reinterpret_cast<Faults*>(jpeg->err)->end, 1);
}

struct Size {
  std::size_t width = 0, height = 0, channels = 0;
};

/// Whether libjpeg reads the header and, unless `out` is empty, fills that with the pixels, both without a
/// doubt; else `why` says what it told. Nothing in here has a destructor that a jump would pass.
bool decodes(std::FILE* file, Size& size, std::span<std::byte> out, char (&why)[JMSG_LENGTH_MAX]) {
  jpeg_decompress_struct jpeg{};
  Faults faults{};
  jpeg.err = jpeg_std_error(&faults.calls);
  faults.calls.error_exit = leave;
  faults.calls.emit_message = keep_warning;
  faults.why = why;
  volatile bool whole = false;
  if (setjmp(faults.end) == 0) {
    jpeg_create_decompress(&jpeg);
    jpeg_stdio_src(&jpeg, file);
    jpeg_read_header(&jpeg, TRUE);
    jpeg_calc_output_dimensions(&jpeg);
    size = {jpeg.output_width, jpeg.output_height, std::size_t(jpeg.output_components)};
    const std::size_t row = size.width * size.channels;
    const bool fits = out.empty() || row * size.height == out.size();
    if (!fits) std::snprintf(why, sizeof why, "it is another file now");
    if (fits && !out.empty()) {
      jpeg_start_decompress(&jpeg);
      while (jpeg.output_scanline < jpeg.output_height) {
        JSAMPROW line = reinterpret_cast<JSAMPROW>(out.data()) + jpeg.output_scanline * row;
        jpeg_read_scanlines(&jpeg, &line, 1);
      }
      jpeg_finish_decompress(&jpeg);
    }
    whole = fits && faults.calls.num_warnings == 0;
  }
  jpeg_destroy_decompress(&jpeg);
  return whole;
}

/// By libjpeg itself: OpenImageIO gives what is missing in a damaged file as grey.
class JpegFile : public PageFile {
 public:
  explicit JpegFile(const std::filesystem::path& file) : file_(file) {
    const auto [size, why] = decode({});
    if (!why.empty()) throw Error(fmt::format("{}: not an image that can be read: {}", file.string(), why));
    format_.width = size.width;
    format_.height = size.height;
    format_.channels = size.channels;
    format_.is_colour = size.channels == 3;
    if (size.channels == 4) format_.note = "values are of cyan, magenta, yellow and black";
  }
  std::size_t pages() override { return 1; }
  PageFormat format(std::size_t) override { return format_; }
  void read(std::size_t page, std::span<std::byte> out) override {
    if (const auto [size, why] = decode(out); !why.empty())
      throw Error(page_fault(file_, page, fmt::format("its data ends early, or is damaged ({})", why)));
  }

 private:
  /// As decodes(); what was wrong is a line.
  std::pair<Size, std::string> decode(std::span<std::byte> out) const {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(file_.c_str(), "rb"), std::fclose);
    if (!file) return {{}, "it cannot be opened"};
    Size size;
    char why[JMSG_LENGTH_MAX] = "";
    if (decodes(file.get(), size, out, why)) return {size, ""};
    return {{}, one_line(why)};
  }

  std::filesystem::path file_;
  PageFormat format_;
};

}  // namespace

std::unique_ptr<PageFile> open_jpeg(const std::filesystem::path& file) {
  return std::make_unique<JpegFile>(file);
}

}  // namespace crest
