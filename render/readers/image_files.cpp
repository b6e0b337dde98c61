#include "render/readers/image_files.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/core.h>

#include "presets/error.h"

namespace crest {
namespace {

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

constexpr const char* preset_key = "crest:preset";

OIIO::ImageSpec with_preset(OIIO::ImageSpec spec, const std::string& preset) {
  if (!preset.empty()) spec.attribute(preset_key, preset);
  return spec;
}

}  // namespace

std::string encode_rgb8(const std::filesystem::path& path, glm::ivec2 size, const void* pixels,
                        const std::string& preset) {
  return encode(path, with_preset({size.x, size.y, 3, OIIO::TypeDesc::UINT8}, preset), pixels);
}

std::string encode_rgba32f(const std::filesystem::path& path, glm::ivec2 size, const void* pixels,
                           const std::string& preset) {
  return encode(path, with_preset({size.x, size.y, 4, OIIO::TypeDesc::FLOAT}, preset), pixels);
}

std::string preset_in_picture_file(const std::filesystem::path& path) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw Error(fmt::format("{}: not an image: {}", path.string(), OIIO::geterror()));
  return std::string(input->spec().get_string_attribute(preset_key));
}

Image read_image_file(const std::filesystem::path& path) {
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
