#include "presets/exchange/xml_text.h"

#include <fmt/core.h>

#include "presets/error.h"

namespace crest {

pugi::xml_document parse_xml(std::string_view text) {
  pugi::xml_document document;
  if (const auto result = document.load_buffer(text.data(), text.size()); !result)
    throw Error(fmt::format("not XML: {} (at byte {})", result.description(), result.offset));
  return document;
}

}  // namespace crest
