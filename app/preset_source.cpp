#include "app/preset_source.h"

#include <fmt/core.h>

#include <cstdio>

#include "presets/error.h"
#include "presets/preset_file.h"
#include "render/files/file_request.h"
#include "render/files/image.h"

namespace crest {
namespace {

constexpr std::size_t largest_preset = 16 << 20;  // bytes

std::string standard_input() {
  std::string text;
  char part[1 << 16];
  while (const std::size_t count = std::fread(part, 1, sizeof part, stdin)) {
    text.append(part, count);
    if (text.size() > largest_preset) break;  // which is refused
  }
  return text;
}

}  // namespace

bool is_picture_file(const std::string& source) {
  const std::string extension = extension_of(source);
  return extension == ".png" || extension == ".exr";
}

Preset load_preset_from(const std::string& source) {
  if (source == "-") return parse_preset(standard_input(), "the standard input");
  if (!is_picture_file(source)) return load_preset(source);
  const std::string text = preset_in_picture(source);
  if (text.empty())
    throw Error(fmt::format("{}: holds no preset: only pictures that Crest saved do", source));
  return parse_preset(text, source);
}

std::string preset_for_picture(Preset preset, const Camera& camera) {
  preset.camera = camera;
  return write_preset(preset);
}

}  // namespace crest
