// Compressed pixels but run lengths, which GDCM decodes.
#include "render/readers/dicom_pixels.h"

#include <fmt/core.h>
#include <gdcmImageReader.h>
#include <gdcmSequenceOfFragments.h>

#include <optional>
#include <sstream>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/dicom_codestream.h"
#include "render/readers/open_file.h"
#include "render/readers/with_gdcm.h"

namespace crest {
namespace {

using gdcm::SequenceOfFragments;

std::optional<ScalarType> type_of(const gdcm::PixelFormat& format) {
  const bool is_signed = format.GetPixelRepresentation() != 0;
  switch (format.GetBitsAllocated()) {
    case 8:
      return is_signed ? ScalarType::int8 : ScalarType::uint8;
    case 16:
      return is_signed ? ScalarType::int16 : ScalarType::uint16;
    case 32:
      return is_signed ? ScalarType::int32 : ScalarType::uint32;
    default:
      return std::nullopt;
  }
}

class CodedPixels : public DicomPixels {
 public:
  CodedPixels(const DicomImage& image, DicomStructure structure, std::size_t frames)
      : name_(image.file.string()),
        image_(image),
        structure_(std::move(structure)),
        frames_(frames),
        samples_(image.columns * image.rows * image.samples),
        is_by_frame_(frames > 1 && structure_.fragments.size() == frames),
        file_(open_file(image.file)) {
    if (image.high_bit + 1 != image.bits_stored) {
      throw Error(
          fmt::format("{}: its compressed pixels have {} bits that end at bit {}, and those that end at bit "
                      "{} are read",
                      name_, image.bits_stored, image.high_bit, image.bits_stored - 1));
    }
  }

  /// The library holds more than one copy of what it decodes.
  std::uint64_t held_bytes() const override {
    constexpr std::uint64_t copies = 4;
    const std::uint64_t frame = copies * samples_ * ((image_.bits + 7) / 8);
    const std::uint64_t copied = is_padded() ? structure_.end : 0;
    return copied + (is_by_frame_ ? frame + std::filesystem::file_size(image_.file) : frame * frames_);
  }
  ScalarType type() const override { return type_; }

  std::span<const std::byte> frame(std::size_t number) override {
    if (frame_bytes_ == 0) read();
    if (!is_by_frame_ && decoded_.empty()) decode(all(), frames_);
    if (!is_by_frame_) return std::span(decoded_).subspan(number * frame_bytes_, frame_bytes_);
    require_codestream(structure_.fragments[number]);
    decode(one(number), 1);
    return decoded_;
  }

 private:
  const gdcm::Image& all() const { return reader_.GetImage(); }
  bool is_padded() const { return structure_.end < std::filesystem::file_size(image_.file); }

  /// The library decodes no pixels here.
  void read() {
    std::optional<Codestream> stream;
    for (const DicomFragment& fragment : structure_.fragments) {
      const auto its = require_codestream(fragment);
      if (!stream) stream = its;
      if (is_by_frame_) break;  // the others as they are decoded
    }
    if (is_padded()) {  // the library takes what pads the file for elements
      head_.str(read_head(image_.file, structure_.end));
      reader_.SetStream(head_);
    } else {
      reader_.SetFileName(image_.file.c_str());
    }
    with_gdcm(name_, [&] { return reader_.Read(); });
    if (stream && stream->kind != Codestream::Kind::jpeg_2000) take_bits(*stream);
    if (stream && stream->is_signed) take_sign();
    const gdcm::PixelFormat& format = all().GetPixelFormat();
    const auto type = type_of(format);
    if (!type) {
      throw Error(fmt::format("{}: its pixels have {} bits, and compressed ones of 8, 16 and 32 are read",
                              name_, format.GetBitsAllocated()));
    }
    type_ = *type;
    frame_bytes_ = samples_ * size_of(type_);
    if (all().GetBufferLength() != frame_bytes_ * frames_) {
      throw Error(fmt::format("{}: the header promises {} bytes of pixels, and the file has {}", name_,
                              frame_bytes_ * frames_, all().GetBufferLength()));
    }
    fragments_ = all().GetDataElement().GetSequenceOfFragments();
    is_by_frame_ = is_by_frame_ && fragments_ && fragments_->GetNumberOfFragments() == frames_;
  }

  /// Where the header says more bits than are coded, the library goes by either.
  void take_bits(const Codestream& stream) {
    const auto bits = std::uint16_t(stored_bits(stream));
    if (bits == image_.bits && all().GetPixelFormat().GetBitsAllocated() == bits) return;
    const auto stored = std::uint16_t(std::min<std::uint64_t>(image_.bits_stored, bits));
    reader_.GetImage().SetPixelFormat(gdcm::PixelFormat(std::uint16_t(image_.samples), bits, stored,
                                                        std::uint16_t(stored - 1), image_.is_signed ? 1 : 0));
  }

  /// What is coded as signed is so, also where the header does not say it.
  void take_sign() {
    gdcm::PixelFormat format = all().GetPixelFormat();
    format.SetPixelRepresentation(1);
    reader_.GetImage().SetPixelFormat(format);
  }

  gdcm::Image one(std::size_t number) const {
    const gdcm::SmartPointer<SequenceOfFragments> fragment = new SequenceOfFragments;
    fragment->AddFragment(fragments_->GetFragment(number));
    gdcm::DataElement element(gdcm::Tag(0x7fe0, 0x0010), 0, gdcm::VR::OB);
    element.SetValue(*fragment);
    gdcm::Image image = all();
    image.SetNumberOfDimensions(2);
    image.SetDataElement(element);
    return image;
  }

  /// The library may find others in the compressed data than the header says.
  void require_as_said(const gdcm::PixelFormat& format) const {
    const unsigned all = 8 * unsigned(size_of(type_)), stored = format.GetBitsStored(),
                   high_bit = format.GetHighBit();
    if (type_of(format) == type_ && stored > 0 && stored <= high_bit + 1 && high_bit < all) return;
    throw Error(
        fmt::format("{}: its header says pixels of {} bits, and the compressed ones have {} bits that end at "
                    "bit {}, in {}",
                    name_, all, stored, high_bit, format.GetBitsAllocated()));
  }

  /// Of what begins an image. The library decodes what it finds, and hands out as many bytes as the header
  /// promises.
  std::optional<Codestream> require_codestream(const DicomFragment& fragment) {
    std::vector<std::byte> bytes(fragment.bytes);
    file_.seekg(std::streamoff(fragment.begin));
    file_.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    const auto stream = read_codestream(bytes);
    if (!stream) return stream;
    const bool has_size = stream->columns == image_.columns && stream->samples == image_.samples &&
                          (stream->rows == image_.rows || stream->rows == 0);
    const bool is_longer = stream->bits > image_.bits, is_shorter = stored_bits(*stream) < image_.bits;
    const bool has_bits = stream->kind == Codestream::Kind::jpeg_2000 ||
                          (!is_longer && image_.bits <= 16 && !(is_shorter && image_.is_signed));
    if (has_size && has_bits) return stream;
    throw Error(
        fmt::format("{}: the DICOM file is damaged: its header says {}x{} pixels of {} x {} bits, and the "
                    "compressed ones are {}x{} of {} x {}",
                    name_, image_.columns, image_.rows, image_.samples, image_.bits, stream->columns,
                    stream->rows, stream->samples, stream->bits));
  }
  /// In which a sample is decoded.
  static unsigned stored_bits(const Codestream& stream) { return stream.bits <= 8 ? 8 : 16; }

  void decode(const gdcm::Image& image, std::size_t frames) {
    decoded_.resize(frame_bytes_ * frames);
    with_gdcm(name_, [&] {
      return image.GetBufferLength() == decoded_.size() &&
             image.GetBuffer(reinterpret_cast<char*>(decoded_.data()));
    });
    const gdcm::PixelFormat& format = image.GetPixelFormat();
    require_as_said(format);
    had_other_bits_ |= keep_stored_bits(decoded_, type_, format.GetBitsStored(), format.GetHighBit());
    const std::size_t samples = format.GetSamplesPerPixel();
    if (samples < 2 || image.GetPlanarConfiguration() == 0) return;
    for (std::size_t begin = 0; begin < decoded_.size(); begin += frame_bytes_) {
      const auto frame = std::span(decoded_).subspan(begin, frame_bytes_);
      std::ranges::copy(joined_planes(frame, samples, size_of(type_)), frame.begin());
    }
  }

  std::string name_;
  DicomImage image_;
  DicomStructure structure_;
  std::size_t frames_;
  std::uint64_t samples_;  ///< of a frame
  bool is_by_frame_;       ///< each is a fragment
  std::ifstream file_;
  std::istringstream head_;
  gdcm::ImageReader reader_;
  ScalarType type_ = ScalarType::uint16;
  std::uint64_t frame_bytes_ = 0;
  const SequenceOfFragments* fragments_ = nullptr;
  std::vector<std::byte> decoded_;
};

}  // namespace

std::unique_ptr<DicomPixels> open_dicom_pixels(const DicomImage& image, std::size_t frames) {
  DicomStructure structure = read_dicom_structure(image.file);
  if (structure.pixels) return open_plain_pixels(image, *structure.pixels);
  if (structure.is_run_lengths) {
    if (structure.fragments.size() != frames)
      throw Error(
          fmt::format("{}: the DICOM file is damaged: it has {} frames in {} fragments of run lengths",
                      image.file.string(), frames, structure.fragments.size()));
    return open_run_lengths(image, std::move(structure.fragments));
  }
  return std::make_unique<CodedPixels>(image, std::move(structure), frames);
}

}  // namespace crest
