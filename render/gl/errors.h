#pragma once

#include <glm/vec2.hpp>
#include <string_view>

#include "presets/error.h"

namespace crest::gl {

/// The graphics device has no room for something; where other things go, it may have.
struct NoRoom : Error {
  using Error::Error;
};

/// Forgets the errors that GL noted so far, whoever made them.
void forget_errors();

/// Throws Error if GL noted an error since then, NoRoom where it is out of memory: "the graphics driver
/// failed while `doing`".
void require_no_error(std::string_view doing);
/// The same of `doing` ("drawing") a picture of `size`.
void require_no_error(std::string_view doing, glm::ivec2 size);

}  // namespace crest::gl
