#pragma once

#include <filesystem>

namespace crest {

// OpenImageIO gives what is missing in a damaged image as black, grey or as what is there by chance. So
// libtiff and libjpeg, which can tell, decode such a file once before. Both throw Error for what does not
// hold all its pixels.

/// Of all pages; the error has the page's number, from 1.
void require_whole_tiff(const std::filesystem::path& file);
void require_whole_jpeg(const std::filesystem::path& file);

}  // namespace crest
