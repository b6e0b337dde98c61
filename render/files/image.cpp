#include "render/files/image.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "presets/atomic_file.h"
#include "presets/error.h"
#include "render/files/file_modules.h"
#include "render/files/read_beside.h"

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

}  // namespace

Image over_background(Image image, glm::vec3 background) {
  for (auto& pixel : image.pixels) pixel = glm::vec4(glm::vec3(pixel) + (1 - pixel.a) * background, 1);
  return image;
}

void require_picture_file(const std::filesystem::path& path) {
  const auto extension = path.extension();
  if (extension != ".png" && extension != ".exr")
    throw Error(fmt::format("{}: a picture's name ends with .png or .exr", path.string()));
  require_writable(path);
}

std::string encode_image(const std::filesystem::path& path, const Image& image, glm::vec3 background,
                         const std::string& preset) {
  if (path.extension() == ".exr")
    return image_module().encode_rgba32f(path, image.size, image.pixels.data(), preset);
  const auto bytes = rgb_bytes(over_background(image, background));
  return image_module().encode_rgb8(path, image.size, bytes.data(), preset);
}

void write_image(const std::filesystem::path& path, const Image& image, glm::vec3 background,
                 const std::string& preset) {
  require_picture_file(path);
  write_file_atomically(path, encode_image(path, image, background, preset));
}

std::string png_of(const Image& image, glm::vec3 background) {
  return encode_image("picture.png", image, background);
}

std::string preset_in_picture(const std::filesystem::path& path) {
  constexpr std::uintmax_t largest = std::uintmax_t(4) << 30;  // 16,384 x 16,384 points of four floats
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored) && std::filesystem::file_size(path, ignored) > largest)
    throw Error(fmt::format("{}: larger than any picture that Crest saves", path.string()));
  return read_preset_beside({path});
}

Image read_image(const std::filesystem::path& path) { return read_picture_beside({path}); }

}  // namespace crest
