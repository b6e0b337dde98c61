#include "render/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "presets/atomic_file.h"
#include "presets/error.h"

namespace crest {
namespace {

std::vector<std::uint8_t> rgb_bytes(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels.size() * 3);
  for (const auto& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel)
      bytes.push_back(std::uint8_t(std::lround(255 * std::clamp(pixel[channel], 0.f, 1.f))));
  return bytes;
}

/// The whole file in memory: OpenImageIO does not notice that a PNG was cut off by a full disk.
std::string encode(const std::filesystem::path& path, const OIIO::ImageSpec& spec, const void* pixels) {
  std::vector<unsigned char> file;
  OIIO::Filesystem::IOVecOutput memory(file);
  const auto output = OIIO::ImageOutput::create(path.string());
  if (!output || !output->set_ioproxy(&memory) || !output->open(path.string(), spec) ||
      !output->write_image(spec.format, pixels) || !output->close())
    throw Error(fmt::format("{}: cannot be written: {}", path.string(),
                            output ? output->geterror() : OIIO::geterror()));
  return {file.begin(), file.end()};
}

std::string encode_png(const std::filesystem::path& path, const Image& image, glm::vec3 background) {
  const auto bytes = rgb_bytes(over_background(image, background));
  return encode(path, {image.size.x, image.size.y, 3, OIIO::TypeDesc::UINT8}, bytes.data());
}

std::string encode_exr(const std::filesystem::path& path, const Image& image) {
  return encode(path, {image.size.x, image.size.y, 4, OIIO::TypeDesc::FLOAT}, image.pixels.data());
}

}  // namespace

Image over_background(Image image, glm::vec3 background) {
  for (auto& pixel : image.pixels) pixel = glm::vec4(glm::vec3(pixel) + (1 - pixel.a) * background, 1);
  return image;
}

void write_image(const std::filesystem::path& path, const Image& image, glm::vec3 background) {
  const auto extension = path.extension();
  if (extension != ".png" && extension != ".exr")
    throw Error(fmt::format("{}: a picture's name ends with .png or .exr", path.string()));
  write_file_atomically(path,
                        extension == ".png" ? encode_png(path, image, background) : encode_exr(path, image));
}

std::string png_of(const Image& image, glm::vec3 background) {
  return encode_png("picture.png", image, background);
}

Image read_image(const std::filesystem::path& path) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw Error(fmt::format("{}: not an image: {}", path.string(), OIIO::geterror()));
  const auto& spec = input->spec();
  const auto channels = std::size_t(spec.nchannels);
  const auto count = std::size_t(spec.width) * std::size_t(spec.height);
  std::vector<float> values(count * channels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
    throw Error(fmt::format("{}: cannot be read: {}", path.string(), input->geterror()));
  Image image{{spec.width, spec.height}, std::vector<glm::vec4>(count)};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t channel = 0; channel < 4; ++channel)
      image.pixels[i][int(channel)] = channel < channels ? values[i * channels + channel]
                                      : channel == 3     ? 1.f
                                      : channels < 3     ? values[i * channels]
                                                         : 0.f;
  return image;
}

}  // namespace crest
