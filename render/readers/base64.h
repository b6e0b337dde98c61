#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace crest {

/// The first `count` bytes that base64 text holds, or as many as there are. White space is passed over;
/// padding within it ends a group of its own, since VTK joins several texts.
std::vector<std::byte> decode_base64(std::string_view text, std::size_t count);

}  // namespace crest
