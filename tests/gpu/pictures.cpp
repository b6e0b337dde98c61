// What reads and writes files, in the bundle: PNG alone, by stb_image, in place of OpenImageIO with
// its 270 libraries of 360 MB.
#include <fmt/core.h>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <memory>

#include "presets/error.h"
#include "render/files/file_modules.h"
#include "render/readers/page_file.h"

namespace crest {
namespace {

std::unique_ptr<PageFile> open_pages(const std::filesystem::path& path) {
  throw Error(fmt::format("{}: this bundle reads builtin: and RAW volumes alone", path.string()));
}
std::string encode_rgb8(const std::filesystem::path& path, glm::ivec2 size, const void* pixels,
                        const std::string&) {
  if (path.extension() != ".png") throw Error(fmt::format("{}: this bundle writes PNG alone", path.string()));
  std::string bytes;
  const auto append = [](void* to, void* data, int count) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), std::size_t(count));
  };
  if (!stbi_write_png_to_func(append, &bytes, size.x, size.y, 3, pixels, 3 * size.x))
    throw Error(fmt::format("{}: cannot be written", path.string()));
  return bytes;
}

std::string encode_rgba32f(const std::filesystem::path& path, glm::ivec2, const void*, const std::string&) {
  throw Error(fmt::format("{}: this bundle writes PNG alone", path.string()));
}

std::string preset_in_picture(const std::filesystem::path&) { return ""; }

Image read_image(const std::filesystem::path& path) {
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> bytes(
      stbi_load(path.c_str(), &image.size.x, &image.size.y, &channels, 4), stbi_image_free);
  if (!bytes) throw Error(fmt::format("{}: not an image", path.string()));
  for (int i = 0; i < image.size.x * image.size.y; ++i) {
    const stbi_uc* pixel = bytes.get() + 4 * i;
    image.pixels.emplace_back(glm::vec4(pixel[0], pixel[1], pixel[2], pixel[3]) / 255.0f);
  }
  return image;
}

constexpr ImageModule module{open_pages, preset_in_picture, read_image, encode_rgb8, encode_rgba32f};

}  // namespace
}  // namespace crest

extern "C" __attribute__((visibility("default"))) const crest::ImageModule* crest_image_module() {
  return &crest::module;
}
