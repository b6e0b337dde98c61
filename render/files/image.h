#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace crest {

/// Premultiplied RGBA in 32-bit float, row 0 at the top, x fastest.
struct Image {
  glm::ivec2 size{0};
  std::vector<glm::vec4> pixels;
  const glm::vec4& at(int x, int y) const {
    return pixels[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
  }
  glm::vec4& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(size.x) + std::size_t(x)]; }
};

/// The image over an opaque background.
Image over_background(Image image, glm::vec3 background);

/// Throws Error where write_image() would, as far as that can be told before there is an image: the ending,
/// the folder.
void require_picture_file(const std::filesystem::path& path);

/// Writes a .png (8-bit RGB over the background) or an .exr (premultiplied RGBA in 32-bit float, no
/// background). Throws Error for another ending, or when it cannot be written; the file appears whole or not
/// at all. `preset` is a preset's text, which is kept in the file, unless it is empty.
void write_image(const std::filesystem::path& path, const Image& image, glm::vec3 background,
                 const std::string& preset = {});

/// What such a file holds; the ending of `path` alone counts.
std::string encode_image(const std::filesystem::path& path, const Image& image, glm::vec3 background,
                         const std::string& preset = {});

/// The text of the preset that such a file holds; empty where it holds none. Throws Error for what is no
/// picture.
std::string preset_in_picture(const std::filesystem::path& path);

/// A .png's bytes.
std::string png_of(const Image& image, glm::vec3 background);

/// Reads an image file as premultiplied RGBA (alpha 1 where it has none). Throws Error.
Image read_image(const std::filesystem::path& path);

}  // namespace crest
