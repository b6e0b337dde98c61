#include <fmt/core.h>
#include <gdcmImageReader.h>
#include <gdcmReader.h>

#include <cstring>
#include <optional>

#include "presets/error.h"
#include "render/readers/dicom_image.h"
#include "render/readers/with_gdcm.h"

namespace crest {
namespace {

std::optional<ScalarType> type_of(const gdcm::PixelFormat& format) {
  const bool is_signed = format.GetPixelRepresentation() != 0;
  switch (format.GetScalarType()) {
    case gdcm::PixelFormat::FLOAT16:
      return ScalarType::float16;
    case gdcm::PixelFormat::FLOAT32:
      return ScalarType::float32;
    case gdcm::PixelFormat::FLOAT64:
      return ScalarType::float64;
    default:
      break;
  }
  switch (format.GetBitsAllocated()) {
    case 8:
      return is_signed ? ScalarType::int8 : ScalarType::uint8;
    case 16:
      return is_signed ? ScalarType::int16 : ScalarType::uint16;
    case 32:
      return is_signed ? ScalarType::int32 : ScalarType::uint32;
    case 64:
      return is_signed ? ScalarType::int64 : ScalarType::uint64;
    default:
      return std::nullopt;
  }
}

/// Bits above those stored may hold an overlay, and the sign is the highest stored bit (PS3.5, 8.1.1).
template <class T>
void keep_stored_bits(std::vector<std::byte>& bytes, unsigned stored) {
  constexpr unsigned all = 8 * sizeof(T);
  if (stored == 0 || stored >= all) return;
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + i, sizeof(T));
    using Unsigned = std::make_unsigned_t<T>;
    value = T(T(Unsigned(Unsigned(value) << (all - stored))) >> (all - stored));
    std::memcpy(bytes.data() + i, &value, sizeof(T));
  }
}

void keep_stored_bits(const gdcm::PixelFormat& format, DicomPixels& pixels) {
  if (!is_integer(pixels.type) || format.GetHighBit() + 1 != format.GetBitsStored()) return;
  with_scalar_type(pixels.type, [&](auto zero) {
    using T = decltype(zero);
    if constexpr (std::is_integral_v<T>) keep_stored_bits<T>(pixels.bytes, format.GetBitsStored());
  });
}

/// A pixel's samples together, where the file has them in a plane of each.
void join_planes(const gdcm::Image& image, std::size_t sample_bytes, DicomPixels& pixels) {
  const std::size_t samples = image.GetPixelFormat().GetSamplesPerPixel();
  if (samples < 2 || image.GetPlanarConfiguration() == 0) return;
  const std::size_t plane = std::size_t(image.GetDimension(0)) * image.GetDimension(1);
  std::vector<std::byte> joined(pixels.bytes.size());
  const std::size_t frame = plane * samples * sample_bytes;
  for (std::size_t begin = 0; begin + frame <= joined.size(); begin += frame) {
    for (std::size_t s = 0; s < samples; ++s)
      for (std::size_t i = 0; i < plane; ++i)
        std::memcpy(joined.data() + begin + (i * samples + s) * sample_bytes,
                    pixels.bytes.data() + begin + (s * plane + i) * sample_bytes, sample_bytes);
  }
  pixels.bytes = std::move(joined);
}

}  // namespace

DicomPixels read_dicom_pixels(const std::filesystem::path& file, std::uint64_t count) {
  const std::string name = file.string();
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  with_gdcm(name, [&] { return reader.Read(); });
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat format = image.GetPixelFormat();
  const auto type = type_of(format);
  if (!type) {
    throw Error(fmt::format("{}: its pixels have {} bits, and those of 8, 16, 32 and 64 are read", name,
                            format.GetBitsAllocated()));
  }
  DicomPixels pixels{*type, {}};
  if (image.GetBufferLength() != count * size_of(*type)) {
    throw Error(fmt::format("{}: the header promises {} bytes of pixels, and the file has {}", name,
                            count * size_of(*type), image.GetBufferLength()));
  }
  pixels.bytes.resize(image.GetBufferLength());
  with_gdcm(name, [&] { return image.GetBuffer(reinterpret_cast<char*>(pixels.bytes.data())); });
  keep_stored_bits(format, pixels);
  join_planes(image, size_of(*type), pixels);
  return pixels;
}

DicomPixels read_dicom_reals(const std::filesystem::path& file, std::uint64_t count) {
  const std::string name = file.string();
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  with_gdcm(name, [&] { return reader.Read(); });
  if (reader.GetFile().GetHeader().GetDataSetTransferSyntax() == gdcm::TransferSyntax::ExplicitVRBigEndian)
    throw Error(fmt::format("{}: floating-point pixels in big-endian order are not read", name));
  const gdcm::DataSet& set = reader.GetFile().GetDataSet();
  for (const auto& [tag, type] : {std::pair(gdcm::Tag(0x7fe0, 0x0008), ScalarType::float32),
                                  {gdcm::Tag(0x7fe0, 0x0009), ScalarType::float64}}) {
    const gdcm::ByteValue* value =
        set.FindDataElement(tag) ? set.GetDataElement(tag).GetByteValue() : nullptr;
    if (!value || value->GetLength() != count * size_of(type)) continue;
    DicomPixels pixels{type, std::vector<std::byte>(value->GetLength())};
    std::memcpy(pixels.bytes.data(), value->GetPointer(), pixels.bytes.size());
    return pixels;
  }
  throw Error(fmt::format("{}: it does not hold the {} floating-point pixels that it promises", name, count));
}

}  // namespace crest
