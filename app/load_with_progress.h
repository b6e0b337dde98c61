#pragma once

#include <string>

#include "render/volume/volume.h"

namespace crest {

/// As load_volume(), for a command: where it takes a while, and stderr is a terminal, it shows how far it is.
Volume load_with_progress(const std::string& source);

}  // namespace crest
