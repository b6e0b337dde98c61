#pragma once

#include <filesystem>
#include <string>

#include "render/files/image.h"

namespace crest {

// As ImageModule says.
std::string encode_rgb8(const std::filesystem::path& path, glm::ivec2 size, const void* pixels,
                        const std::string& preset);
std::string encode_rgba32f(const std::filesystem::path& path, glm::ivec2 size, const void* pixels,
                           const std::string& preset);
std::string preset_in_picture_file(const std::filesystem::path& path);
Image read_image_file(const std::filesystem::path& path);

}  // namespace crest
