// Pixels that are not compressed (PS3.5, 8.1 and 8.2; Annex D has pictures; PS3.3, C.7.6.3.1.2).
#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "presets/error.h"
#include "render/readers/dicom_pixels.h"
#include "render/readers/open_file.h"

namespace crest {
namespace {

ScalarType type_of(const DicomImage& image, DicomNumbers numbers) {
  if (numbers == DicomNumbers::float32) return ScalarType::float32;
  if (numbers == DicomNumbers::float64) return ScalarType::float64;
  switch (image.bits) {
    case 1:
      return ScalarType::uint8;
    case 8:
      return image.is_signed ? ScalarType::int8 : ScalarType::uint8;
    case 16:
      return image.is_signed ? ScalarType::int16 : ScalarType::uint16;
    case 32:
      return image.is_signed ? ScalarType::int32 : ScalarType::uint32;
    case 64:
      return image.is_signed ? ScalarType::int64 : ScalarType::uint64;
    default:
      throw Error(fmt::format("{}: its pixels have {} bits, and those of 1, 8, 16, 32 and 64 are read",
                              image.file.string(), image.bits));
  }
}

void require_bits(const DicomImage& image) {
  if (image.bits_stored <= image.bits && image.high_bit < image.bits &&
      image.high_bit + 1 >= image.bits_stored)
    return;
  throw Error(
      fmt::format("{}: the DICOM file is damaged: its pixels have {} bits, of which {} that end at "
                  "bit {} are used",
                  image.file.string(), image.bits, image.bits_stored, image.high_bit));
}

/// Of pairs of pixels that share colours (Y1 Y2 Cb Cr), the samples of each.
std::vector<std::byte> spread_colours(std::span<const std::byte> pairs, std::size_t sample_bytes) {
  constexpr std::size_t order[] = {0, 2, 3, 1, 2, 3};
  std::vector<std::byte> spread(pairs.size() / 4 * std::size(order));
  std::byte* out = spread.data();
  for (std::size_t at = 0; at < pairs.size(); at += 4 * sample_bytes) {
    for (const std::size_t sample : order) {
      std::memcpy(out, pairs.data() + at + sample * sample_bytes, sample_bytes);
      out += sample_bytes;
    }
  }
  return spread;
}

class PlainPixels : public DicomPixels {
 public:
  PlainPixels(const DicomImage& image, const DicomPlace& place)
      : name_(image.file.string()),
        image_(image),
        place_(place),
        type_(dicom_type(image, place.numbers)),
        is_packed_(image.bits == 1 && place.numbers == DicomNumbers::integers),
        samples_(image.columns * image.rows * image.samples),
        stored_(shares_colours(image) ? image.columns * image.rows * 2 : samples_),
        file_(open_file(image.file)) {
    if (shares_colours(image) && (image.columns % 2 != 0 || image.has_planes || is_packed_))
      throw Error(
          fmt::format("{}: the DICOM file is damaged: its pixels are {}, of which two share their "
                      "colours, and its rows are no pairs of them",
                      name_, image.photometric));
  }

  ScalarType type() const override { return type_; }
  std::uint64_t held_bytes() const override { return 2 * samples_ * size_of(type_); }

  std::span<const std::byte> frame(std::size_t number) override {
    is_packed_ ? unpack(number) : take(number);
    return frame_;
  }

 private:
  void take(std::size_t number) {
    frame_ = bytes_at(number * stored_ * size_of(type_), stored_ * size_of(type_));
    if (is_integer(type_))
      had_other_bits_ |=
          keep_stored_bits(frame_, type_, unsigned(image_.bits_stored), unsigned(image_.high_bit));
    if (image_.has_planes) frame_ = joined_planes(frame_, image_.samples, size_of(type_));
    if (shares_colours(image_)) frame_ = spread_colours(frame_, size_of(type_));
  }
  /// Pixels of one bit, the lowest one first. A frame may begin within a byte.
  void unpack(std::size_t number) {
    const std::uint64_t begin = number * samples_, end = begin + samples_;
    const std::vector<std::byte> bits = bytes_at(begin / 8, (end + 7) / 8 - begin / 8);
    frame_.resize(samples_);
    for (std::uint64_t i = 0; i < samples_; ++i) {
      const std::uint64_t bit = begin % 8 + i;
      frame_[i] = bits[bit / 8] >> (bit % 8) & std::byte{1};
    }
  }
  /// In the machine's order, which is little-endian.
  std::vector<std::byte> bytes_at(std::uint64_t begin, std::uint64_t count) {
    if (begin + count > place_.bytes) fail();  // the file is another one by now
    const std::uint64_t word = place_.swapped, first = begin / word * word,
                        last = std::min((begin + count + word - 1) / word * word, place_.bytes);
    std::vector<std::byte> bytes(last - first);
    file_.seekg(std::streamoff(place_.begin + first));
    if (!file_.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()))) fail();
    if (word > 1) swap_bytes(bytes, word);
    bytes.erase(bytes.begin(), bytes.begin() + std::ptrdiff_t(begin - first));
    bytes.resize(count);
    return bytes;
  }

  [[noreturn]] void fail() const {
    throw Error(fmt::format("{}: its pixels could not be read to their end", name_));
  }

  std::string name_;
  DicomImage image_;
  DicomPlace place_;
  ScalarType type_;
  bool is_packed_;
  std::uint64_t samples_;  ///< of a frame
  std::uint64_t stored_;   ///< those of them that the file has
  std::ifstream file_;
  std::vector<std::byte> frame_;
};

template <class T>
bool keep_bits(std::span<std::byte> bytes, unsigned stored, unsigned high_bit) {
  constexpr unsigned all = 8 * sizeof(T);
  if (stored == all) return false;
  using Unsigned = std::make_unsigned_t<T>;
  const unsigned low_bit = high_bit + 1 - stored;
  const auto above = Unsigned(high_bit + 1 < all ? ~std::uint64_t(0) << (high_bit + 1) : 0);
  bool has_others = false;
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
    T whole;
    std::memcpy(&whole, bytes.data() + i, sizeof(T));
    const T value = T(T(Unsigned(Unsigned(whole) << (all - 1 - high_bit))) >> (all - stored));
    const auto placed = Unsigned(Unsigned(value) << low_bit);  // with its sign above it, or not
    has_others = has_others || (Unsigned(whole) != placed && Unsigned(whole) != Unsigned(placed & ~above));
    std::memcpy(bytes.data() + i, &value, sizeof(T));
  }
  return has_others;
}

}  // namespace

ScalarType dicom_type(const DicomImage& image, DicomNumbers numbers) {
  const ScalarType type = type_of(image, numbers);
  if (is_integer(type)) require_bits(image);
  return type;
}

bool keep_stored_bits(std::span<std::byte> bytes, ScalarType type, unsigned stored, unsigned high_bit) {
  bool has_others = false;
  with_scalar_type(type, [&](auto zero) {
    using T = decltype(zero);
    if constexpr (std::is_integral_v<T>) has_others = keep_bits<T>(bytes, stored, high_bit);
  });
  return has_others;
}

std::vector<std::byte> joined_planes(std::span<const std::byte> planes, std::size_t samples,
                                     std::size_t sample_bytes) {
  const std::size_t pixels = planes.size() / samples / sample_bytes;
  std::vector<std::byte> joined(planes.size());
  for (std::size_t s = 0; s < samples; ++s)
    for (std::size_t i = 0; i < pixels; ++i)
      std::memcpy(joined.data() + (i * samples + s) * sample_bytes,
                  planes.data() + (s * pixels + i) * sample_bytes, sample_bytes);
  return joined;
}

std::unique_ptr<DicomPixels> open_plain_pixels(const DicomImage& image, const DicomPlace& place) {
  return std::make_unique<PlainPixels>(image, place);
}

}  // namespace crest
