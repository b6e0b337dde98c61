#pragma once

#include <filesystem>

namespace crest {

/// OpenImageIO gives what is missing in a damaged JPEG file as grey. So libjpeg, which can tell, decodes such
/// a file once before. Throws Error for what does not hold all its pixels.
void require_whole_jpeg(const std::filesystem::path& file);

}  // namespace crest
