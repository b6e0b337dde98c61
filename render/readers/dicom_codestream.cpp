#include "render/readers/dicom_codestream.h"

#include <cstddef>

namespace crest {
namespace {

/// Big-endian numbers, one after the other; 0 behind the end.
class Numbers {
 public:
  explicit Numbers(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::uint64_t take(std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i, ++at_)
      value = value << 8 | (at_ < bytes_.size() ? std::to_integer<std::uint64_t>(bytes_[at_]) : 0);
    return value;
  }
  void skip(std::size_t count) { at_ += count; }
  bool at_end() const { return at_ >= bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

constexpr std::uint64_t start_of_image = 0xffd8, start_of_scan = 0xda, start_of_codestream = 0xff4fff51;

std::optional<Codestream::Kind> frame_kind(std::uint64_t marker) {
  if (marker == 0xf7) return Codestream::Kind::jpeg_ls;
  const bool is_table = marker == 0xc4 || marker == 0xc8 || marker == 0xcc;
  return marker >= 0xc0 && marker <= 0xcf && !is_table ? std::optional(Codestream::Kind::jpeg) : std::nullopt;
}

std::optional<Codestream> read_jpeg(Numbers numbers) {
  numbers.skip(2);
  while (!numbers.at_end()) {
    if (numbers.take(1) != 0xff) return std::nullopt;
    std::uint64_t marker = numbers.take(1);
    while (marker == 0xff && !numbers.at_end()) marker = numbers.take(1);
    if (marker == start_of_scan) return std::nullopt;
    const std::uint64_t length = numbers.take(2);
    if (const auto kind = frame_kind(marker)) {
      Codestream stream{*kind};
      stream.bits = unsigned(numbers.take(1));
      stream.rows = numbers.take(2);
      stream.columns = numbers.take(2);
      stream.samples = unsigned(numbers.take(1));
      return stream;
    }
    numbers.skip(length < 2 ? 0 : length - 2);
  }
  return std::nullopt;
}

/// The first component's bits.
Codestream read_jpeg_2000(Numbers numbers) {
  numbers.skip(8);  // two markers, a length and capabilities
  const std::uint64_t right = numbers.take(4), bottom = numbers.take(4), left = numbers.take(4),
                      top = numbers.take(4);
  numbers.skip(16);  // tiles
  Codestream stream{Codestream::Kind::jpeg_2000};
  stream.columns = right - left;
  stream.rows = bottom - top;
  stream.samples = unsigned(numbers.take(2));
  const auto depth = unsigned(numbers.take(1));
  stream.bits = (depth & 0x7f) + 1;
  stream.is_signed = (depth & 0x80) != 0;
  return stream;
}

}  // namespace

std::optional<Codestream> read_codestream(std::span<const std::byte> bytes) {
  if (Numbers(bytes).take(2) == start_of_image) return read_jpeg(Numbers(bytes));
  if (Numbers(bytes).take(4) == start_of_codestream) return read_jpeg_2000(Numbers(bytes));
  return std::nullopt;
}

}  // namespace crest
