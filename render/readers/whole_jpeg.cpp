#include <fmt/core.h>

#include <csetjmp>
#include <cstdio>
#include <memory>
#include <vector>

#include <jpeglib.h>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/whole_jpeg.h"

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

/// Whether libjpeg decodes the file without a doubt; else `why` says what it told. Nothing in here has a
/// destructor that a jump would pass.
bool decodes(std::FILE* file, std::vector<JSAMPLE>& line, char (&why)[JMSG_LENGTH_MAX]) {
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
    jpeg_start_decompress(&jpeg);
    line.resize(std::size_t(jpeg.output_width) * std::size_t(jpeg.output_components));
    JSAMPROW row = line.data();
    while (jpeg.output_scanline < jpeg.output_height) jpeg_read_scanlines(&jpeg, &row, 1);
    jpeg_finish_decompress(&jpeg);
    whole = faults.calls.num_warnings == 0;
  }
  jpeg_destroy_decompress(&jpeg);
  return whole;
}

}  // namespace

void require_whole_jpeg(const std::filesystem::path& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  std::vector<JSAMPLE> line;
  char why[JMSG_LENGTH_MAX] = "it cannot be opened";
  if (!file || !decodes(file.get(), line, why))
    throw Error(fmt::format("{}: its data ends early, or is damaged ({})", path.string(), one_line(why)));
}

}  // namespace crest
