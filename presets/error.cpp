#include "presets/error.h"

#include "presets/printable.h"

namespace crest {

Error::Error(const std::string& text) : std::runtime_error(printable(text)) {}

}  // namespace crest
