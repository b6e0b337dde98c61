#pragma once

#include <glm/vec2.hpp>
#include <string_view>

namespace crest::gl {

/// Forgets the errors that GL noted so far, whoever made them.
void forget_errors();

/// Throws Error if GL noted an error since then: what was wrong while `doing` ("drawing") a picture of
/// `size`.
void require_no_error(std::string_view doing, glm::ivec2 size);

}  // namespace crest::gl
