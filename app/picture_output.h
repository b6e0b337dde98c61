#pragma once

#include <string>

#include "app/scene_options.h"
#include "render/files/image.h"

namespace crest {

/// Writes a picture to where -o says, in the form that its name's ending or --format says; "-" is the
/// standard output. Throws Error. `preset` as of write_image().
void write_picture(const PictureOptions& options, const Image& image, glm::vec3 background,
                   const std::string& preset = {});

/// Throws Error where write_picture could not write, before there is a picture.
void require_output(const PictureOptions& options);

}  // namespace crest
