#pragma once

#include <string>
#include <vector>

#include "render/files/file_request.h"

namespace crest {

/// Which of a file's named arrays becomes the volume: the one that ?array=NAME says, or the file's `active`
/// one, or the only one. ChoiceNeeded, which lists them, where that leaves it open. Of several, what was
/// taken goes to `note`. `names` is not empty; `active` may be.
std::size_t choose_array(const FileRequest& request, const std::vector<std::string>& names,
                         const std::string& active, std::string& note);

}  // namespace crest
