#pragma once

#include <tiffio.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace crest {

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

/// A TIFF file that libtiff has opened, on its first page. The library's messages are kept, not printed.
struct TiffHandle {
  /// Throws Error for what is no TIFF file.
  explicit TiffHandle(const std::filesystem::path& file);
  TiffHandle(const TiffHandle&) = delete;  // the library knows where `fault` and `doubt` lie
  TiffHandle& operator=(const TiffHandle&) = delete;

  std::string fault;   ///< the last message
  bool doubt = false;  ///< lengths of a page are wrong
  std::unique_ptr<TIFF, CloseTiff> tiff;
};

/// A field of the page that is current.
template <class T>
T tiff_field(TIFF* tiff, std::uint32_t tag, T fallback) {
  T value = fallback;
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

/// All pages of a file, in their order.
struct TiffPages {
  std::vector<std::uint64_t> offsets;  ///< of their directories, in bytes: TIFFSetSubDirectory goes there
  std::vector<std::size_t> whole;      ///< neither smaller copies of others nor masks
};
/// Of a file that was just opened; leaves it on its last page. Throws Error for a page that is damaged or
/// cut off: to the library one that is not there is the end.
TiffPages walk_pages(const std::filesystem::path& file, TiffHandle& handle);

}  // namespace crest
