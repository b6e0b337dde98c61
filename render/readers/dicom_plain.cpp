// Pixels that are not compressed (PS3.5, 8.1 and 8.2; Annex D has pictures).
#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "presets/error.h"
#include "render/readers/dicom_pixels.h"
#include "render/volume/memory.h"

namespace crest {
namespace {

ScalarType type_of(const std::string& name, const DicomImage& image, DicomNumbers numbers) {
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
      throw Error(fmt::format("{}: its pixels have {} bits, and those of 1, 8, 16, 32 and 64 are read", name,
                              image.bits));
  }
}

void require_bits(const std::string& name, const DicomImage& image) {
  if (image.bits_stored <= image.bits && image.high_bit < image.bits &&
      image.high_bit + 1 >= image.bits_stored)
    return;
  throw Error(
      fmt::format("{}: the DICOM file is damaged: its pixels have {} bits, of which {} that end at "
                  "bit {} are used",
                  name, image.bits, image.bits_stored, image.high_bit));
}

class PlainPixels : public DicomPixels {
 public:
  PlainPixels(const DicomImage& image, const DicomPlace& place, std::size_t frames)
      : name_(image.file.string()),
        image_(image),
        place_(place),
        type_(type_of(name_, image, place.numbers)),
        is_packed_(image.bits == 1 && place.numbers == DicomNumbers::integers),
        samples_(image.columns * image.rows * image.samples),
        file_(image.file, std::ios::binary) {
    if (is_integer(type_)) require_bits(name_, image);
    const auto all = checked_product(samples_, frames);
    const auto bytes = all && !is_packed_ ? checked_product(*all, size_of(type_)) : all;
    const std::uint64_t promised = is_packed_ && bytes ? (*bytes + 7) / 8 : bytes.value_or(UINT64_MAX);
    if (promised > place.bytes)
      throw Error(fmt::format("{}: the header promises {} bytes of pixels, and the file has {}", name_,
                              promised, place.bytes));
  }

  ScalarType type() const override { return type_; }
  std::uint64_t held_bytes() const override { return 2 * samples_ * size_of(type_); }

  std::span<const std::byte> frame(std::size_t number) override {
    is_packed_ ? unpack(number) : take(number);
    return frame_;
  }

 private:
  void take(std::size_t number) {
    frame_ = bytes_at(number * samples_ * size_of(type_), samples_ * size_of(type_));
    if (is_integer(type_))
      keep_stored_bits(frame_, type_, unsigned(image_.bits_stored), unsigned(image_.high_bit));
    if (image_.has_planes) frame_ = joined_planes(frame_, image_.samples, size_of(type_));
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
    const std::uint64_t word = place_.swapped, first = begin / word * word,
                        last = std::min((begin + count + word - 1) / word * word, place_.bytes);
    std::vector<std::byte> bytes(last - first);
    file_.seekg(std::streamoff(place_.begin + first));
    if (!file_.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size())))
      throw Error(fmt::format("{}: its pixels could not be read to their end", name_));
    if (word > 1) swap_bytes(bytes, word);
    bytes.erase(bytes.begin(), bytes.begin() + std::ptrdiff_t(begin - first));
    bytes.resize(count);
    return bytes;
  }

  std::string name_;
  DicomImage image_;
  DicomPlace place_;
  ScalarType type_;
  bool is_packed_;
  std::uint64_t samples_;  ///< of a frame
  std::ifstream file_;
  std::vector<std::byte> frame_;
};

template <class T>
void keep_bits(std::span<std::byte> bytes, unsigned stored, unsigned high_bit) {
  constexpr unsigned all = 8 * sizeof(T);
  if (stored == all) return;
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + i, sizeof(T));
    using Unsigned = std::make_unsigned_t<T>;
    value = T(T(Unsigned(Unsigned(value) << (all - 1 - high_bit))) >> (all - stored));
    std::memcpy(bytes.data() + i, &value, sizeof(T));
  }
}

}  // namespace

void keep_stored_bits(std::span<std::byte> bytes, ScalarType type, unsigned stored, unsigned high_bit) {
  with_scalar_type(type, [&](auto zero) {
    using T = decltype(zero);
    if constexpr (std::is_integral_v<T>) keep_bits<T>(bytes, stored, high_bit);
  });
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

std::unique_ptr<DicomPixels> open_plain_pixels(const DicomImage& image, const DicomPlace& place,
                                               std::size_t frames) {
  return std::make_unique<PlainPixels>(image, place, frames);
}

}  // namespace crest
