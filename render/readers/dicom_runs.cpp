// Run lengths (PS3.5, annex G): a frame is a fragment, which has a segment for each byte of each sample.
#include <fmt/core.h>

#include <algorithm>
#include <fstream>

#include "presets/error.h"
#include "render/readers/binary_fields.h"
#include "render/readers/dicom_pixels.h"
#include "render/readers/open_file.h"

namespace crest {
namespace {

constexpr std::size_t most_segments = 15, header_bytes = 4 * (1 + most_segments);

/// The length of the table is known to be there.
std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t at) {
  return BinaryFields{{reinterpret_cast<const char*>(bytes.data()), bytes.size()}}.at<std::uint32_t>(at);
}

/// What may follow the last run: an even length is kept by zeros, or by runs of nothing.
bool is_padding(std::span<const std::byte> rest) {
  return std::ranges::all_of(rest,
                             [](std::byte byte) { return byte == std::byte{0} || byte == std::byte{0x80}; });
}

class RunLengthPixels : public DicomPixels {
 public:
  RunLengthPixels(const DicomImage& image, std::vector<DicomFragment> fragments)
      : name_(image.file.string()),
        image_(image),
        fragments_(std::move(fragments)),
        type_(dicom_type(image, DicomNumbers::integers)),
        pixels_(image.columns * image.rows),
        file_(open_file(image.file)) {
    if (image.bits == 1) throw Error(fmt::format("{}: pixels of 1 bit are not read from run lengths", name_));
  }

  ScalarType type() const override { return type_; }
  std::uint64_t held_bytes() const override {
    const auto longest = std::ranges::max_element(fragments_, {}, &DicomFragment::bytes);
    return pixels_ * image_.samples * size_of(type_) + (longest == fragments_.end() ? 0 : longest->bytes);
  }

  std::span<const std::byte> frame(std::size_t number) override {
    const std::vector<std::byte> coded = read(fragments_.at(number));
    const std::size_t sample_bytes = size_of(type_), segments = image_.samples * sample_bytes;
    const std::size_t said = coded.size() < header_bytes ? 0 : number_at(coded, 0);
    if (said != segments)
      fail(fmt::format(
          "a frame has {} segments of run lengths, and its header promises {}, a byte of a pixel each", said,
          segments));
    frame_.resize(pixels_ * segments);
    for (std::size_t i = 0; i < segments; ++i) {  // of a sample the highest byte first
      const std::size_t begin = number_at(coded, 4 * (1 + i)),
                        end = i + 1 < segments ? number_at(coded, 4 * (2 + i)) : coded.size();
      if (begin < header_bytes || begin > end || end > coded.size())
        fail("its segments do not lie in the frame");
      const std::size_t sample = i / sample_bytes, byte = sample_bytes - 1 - i % sample_bytes;
      decode(std::span(coded).subspan(begin, end - begin), sample * sample_bytes + byte, segments);
    }
    had_other_bits_ |=
        keep_stored_bits(frame_, type_, unsigned(image_.bits_stored), unsigned(image_.high_bit));
    return frame_;
  }

 private:
  std::vector<std::byte> read(const DicomFragment& fragment) {
    std::vector<std::byte> bytes(fragment.bytes);
    file_.seekg(std::streamoff(fragment.begin));
    if (!file_.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size())))
      throw Error(fmt::format("{}: its pixels could not be read to their end", name_));
    return bytes;
  }

  /// A byte of each pixel, from `first` on, so many bytes apart.
  void decode(std::span<const std::byte> runs, std::size_t first, std::size_t stride) {
    std::size_t at = 0, done = 0;
    while (done < pixels_ && at < runs.size()) {
      const int code = std::to_integer<signed char>(runs[at++]);
      if (code == -128) continue;
      const bool repeats = code < 0;
      const std::size_t count = std::size_t(repeats ? 1 - code : 1 + code), coded = repeats ? 1 : count;
      if (coded > runs.size() - at) break;
      if (count > pixels_ - done) fail_size();
      for (std::size_t i = 0; i < count; ++i, ++done)
        frame_[first + done * stride] = runs[at + (repeats ? 0 : i)];
      at += coded;
    }
    if (done < pixels_) fail(fmt::format("a frame's run lengths end after {} of {} pixels", done, pixels_));
    if (!is_padding(runs.subspan(at))) fail_size();
  }

  [[noreturn]] void fail_size() const {
    fail(fmt::format("a frame has more pixels than the {}x{} of its header", image_.columns, image_.rows));
  }
  [[noreturn]] void fail(const std::string& how) const {
    throw Error(fmt::format("{}: the DICOM file is damaged: {}", name_, how));
  }

  std::string name_;
  DicomImage image_;
  std::vector<DicomFragment> fragments_;
  ScalarType type_;
  std::uint64_t pixels_;  ///< of a frame
  std::ifstream file_;
  std::vector<std::byte> frame_;
};

}  // namespace

std::unique_ptr<DicomPixels> open_run_lengths(const DicomImage& image, std::vector<DicomFragment> fragments) {
  return std::make_unique<RunLengthPixels>(image, std::move(fragments));
}

}  // namespace crest
