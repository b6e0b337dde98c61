#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/files/file_request.h"

namespace crest {

/// One of `count` components or frames, counted from 0: Error when there are more than one and the query does
/// not say which, with the text that tells it. `names`: of each one, or empty. What was taken goes to `note`.
std::uint64_t select_one(const FileRequest& request, std::string_view key, std::uint64_t count,
                         std::string& note, const std::vector<std::string>& names = {});

}  // namespace crest
