#pragma once

#include <pugixml.hpp>
#include <string_view>

namespace crest {

/// Parses XML that anyone may have written. Throws Error: what is wrong, and at which byte.
pugi::xml_document parse_xml(std::string_view text);

}  // namespace crest
