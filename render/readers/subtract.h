#pragma once

#include <string>

#include "render/files/file_request.h"
#include "render/volume/convert.h"

namespace crest {

/// `map` with what ?subtract=NUMBER takes away, which the note then says.
LinearMap subtracted(const FileRequest& request, LinearMap map, std::string& note);

}  // namespace crest
