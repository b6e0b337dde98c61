#pragma once

#include <string>
#include <string_view>

#include "render/files/file_request.h"
#include "render/volume/volume.h"

namespace crest::fuzz {

/// Writes a file into a folder that this process has for itself, in place of the one of this name. Its path.
std::string write_scratch(std::string_view name, std::string_view content);

/// The volume of a file, by `read`. Where the query has to say more, each choice is made, the last one first.
/// What is read is then told as the reader's program does, and looked at as the program does.
void read_volume(const std::string& path, Volume (*read)(const FileRequest&));

}  // namespace crest::fuzz
