// A picture of one row needs no more than PNG's frame about a zlib stream (PNG specification, 5 and 11.2).
#include "presets/exchange/png_strip.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace crest {
namespace {

void append_u32(std::string& bytes, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) bytes += char(number >> shift & 0xff);
}

void append_chunk(std::string& file, std::string_view type, const std::string& data) {
  append_u32(file, std::uint32_t(data.size()));
  const std::string checked = std::string(type) + data;
  file += checked;
  append_u32(file,
             std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(checked.data()), uInt(checked.size()))));
}

std::string deflated(const std::string& data) {
  uLongf size = compressBound(uLong(data.size()));
  std::string bytes(size, '\0');
  compress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
           uLong(data.size()));
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string png_strip(const std::vector<glm::dvec4>& pixels, int channels) {
  std::string header, row(1, '\0');  // the row's filter: none
  append_u32(header, std::uint32_t(pixels.size()));
  append_u32(header, 1);
  constexpr char bits = 16, rgb = 2, rgba = 6;
  header += {bits, channels == 4 ? rgba : rgb, 0, 0, 0};
  for (const glm::dvec4& pixel : pixels)
    for (int channel = 0; channel < channels; ++channel) {
      const auto number = unsigned(std::lround(std::clamp(pixel[channel], 0.0, 1.0) * 65535));
      row += char(number >> 8);
      row += char(number & 0xff);
    }
  std::string file("\x89PNG\r\n\x1a\n", 8);
  append_chunk(file, "IHDR", header);
  append_chunk(file, "IDAT", deflated(row));
  append_chunk(file, "IEND", "");
  return file;
}

}  // namespace crest
