#pragma once

#include <filesystem>

namespace crest {

/// Moves a file to the person's bin, from which a file manager brings it back: the home trash of the
/// FreeDesktop.org Trash specification 1.0, in `data_home`/Trash. Throws Error; the file is then where it
/// was. Among the reasons: the bin lies on another file system, to which a file cannot be moved whole.
void move_to_trash(const std::filesystem::path& file, const std::filesystem::path& data_home);

}  // namespace crest
