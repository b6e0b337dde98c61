#include "app/preset_source.h"

#include <fmt/core.h>

#include "presets/error.h"
#include "presets/preset_file.h"
#include "render/files/file_request.h"
#include "render/files/image.h"

namespace crest {

bool is_picture_file(const std::string& source) {
  const std::string extension = extension_of(source);
  return extension == ".png" || extension == ".exr";
}

Preset load_preset_from(const std::string& source) {
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
