#include <OpenImageIO/imageio.h>
#include <fmt/core.h>

#include <cstring>

#include "presets/error.h"
#include "render/files/file_request.h"
#include "render/files/header_text.h"
#include "render/readers/page_file.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

/// By its extension alone: OpenImageIO would try a file that is not what it says with all that it knows.
std::unique_ptr<OIIO::ImageInput> open(const fs::path& file) {
  OIIO::ImageSpec spec, as_stored;
  as_stored["oiio:UnassociatedAlpha"] = 1;
  auto input = OIIO::ImageInput::create(extension_of(file).substr(1));
  if (input && input->open(file.string(), spec, as_stored)) return input;
  throw Error(fmt::format("{}: not an image that can be read: {}", file.string(),
                          one_line(input ? input->geterror() : OIIO::geterror())));
}

ScalarType scalar_type(const std::string& name, OIIO::TypeDesc format) {
  using enum ScalarType;
  switch (format.basetype) {
    case OIIO::TypeDesc::UINT8:
      return uint8;
    case OIIO::TypeDesc::INT8:
      return int8;
    case OIIO::TypeDesc::UINT16:
      return uint16;
    case OIIO::TypeDesc::INT16:
      return int16;
    case OIIO::TypeDesc::UINT32:
      return uint32;
    case OIIO::TypeDesc::INT32:
      return int32;
    case OIIO::TypeDesc::UINT64:
      return uint64;
    case OIIO::TypeDesc::INT64:
      return int64;
    case OIIO::TypeDesc::HALF:
      return float16;
    case OIIO::TypeDesc::FLOAT:
      return float32;
    case OIIO::TypeDesc::DOUBLE:
      return float64;
    default:
      throw Error(fmt::format("{}: its pixels are of a type ({}) that is not read", name, format.c_str()));
  }
}

/// OpenImageIO makes numbers of 10 or 12 bits fill 16: the stored ones come back by rounding, since the whole
/// ones are further apart than what was cut off.
template <class T>
void restore_bits(std::span<std::byte> bytes, unsigned bits) {
  constexpr double whole = double(std::numeric_limits<T>::max());
  const double greatest = double((std::uint64_t(1) << bits) - 1);
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + i, sizeof(T));
    value = T(double(value) * greatest / whole + 0.5);
    std::memcpy(bytes.data() + i, &value, sizeof(T));
  }
}

/// What it turns into colours cannot be turned back.
bool has_palette(const fs::path& file) {
  const std::string extension = extension_of(file);
  std::FILE* const stream = std::fopen(file.c_str(), "rb");
  unsigned char head[32] = {};
  const std::size_t got = stream ? std::fread(head, 1, sizeof head, stream) : 0;
  if (stream) std::fclose(stream);
  if (extension == ".tga") return got > 1 && head[1] == 1;
  return extension == ".bmp" && got == sizeof head && (head[28] | head[29] << 8) <= 8;
}

class OtherFile : public PageFile {
 public:
  explicit OtherFile(const fs::path& file) : file_(file), input_(open(file)) {
    const OIIO::ImageSpec& spec = input_->spec();
    format_ = {std::uint64_t(spec.width),
               std::uint64_t(spec.height),
               std::uint64_t(spec.nchannels),
               scalar_type(file.string(), spec.format),
               false,
               ""};
    format_.is_colour = spec.nchannels >= 3 && spec.channel_name(0) == "R";
    bits_ = unsigned(spec.get_int_attribute("oiio:BitsPerSample", 0));
    if (spec.depth > 1) throw Error(page_fault(file, 0, "it is an image with a depth"));
    if (has_palette(file) && spec.nchannels > 1) {
      throw Error(page_fault(file, 0,
                             "its pixels are numbers of colours in a palette: as PNG or TIFF they are read"));
    }
  }
  std::size_t pages() override { return 1; }
  PageFormat format(std::size_t) override { return format_; }
  void read(std::size_t page, std::span<std::byte> out) override {
    if (!input_->read_image(0, 0, 0, int(format_.channels), input_->spec().format, out.data()))
      throw Error(page_fault(file_, page, one_line(input_->geterror())));
    if (bits_ == 0 || bits_ >= 8 * size_of(format_.type)) return;
    if (format_.type == ScalarType::uint8) restore_bits<std::uint8_t>(out, bits_);
    if (format_.type == ScalarType::uint16) restore_bits<std::uint16_t>(out, bits_);
  }

 private:
  fs::path file_;
  std::unique_ptr<OIIO::ImageInput> input_;
  PageFormat format_;
  unsigned bits_ = 0;
};

}  // namespace

std::unique_ptr<PageFile> open_other_image(const fs::path& file) { return std::make_unique<OtherFile>(file); }

}  // namespace crest
