#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "render/volume/volume.h"

namespace crest {

/// What an image holds, as it is stored: numbers of fewer bits are kept in the next type that has them.
struct PageFormat {
  std::uint64_t width = 0, height = 0, channels = 1;
  ScalarType type = ScalarType::uint8;
  bool is_colour = false;  ///< its first channels are red, green and blue
  std::string note =
      {};  ///< what the values are, where that is not plain: "numbers of colours in its palette"

  std::uint64_t bytes() const { return width * height * channels * size_of(type); }
  bool operator==(const PageFormat&) const = default;
};

/// An image file with one page or more. Values are the stored ones: nothing is scaled to a type's whole
/// range, inverted, coloured or multiplied by alpha.
class PageFile {
 public:
  virtual ~PageFile() = default;
  virtual std::size_t pages() = 0;
  virtual PageFormat format(std::size_t page) = 0;
  /// Fills `out`, format(page).bytes() of them, row by row, channels together, in the machine's byte order.
  /// Throws Error, with the page's number counted from 1.
  virtual void read(std::size_t page, std::span<std::byte> out) = 0;
};

/// By the file's extension.
bool is_tiff(const std::filesystem::path& file);
/// By the file's extension; what is no is_plain_image() is OpenImageIO's. Throws Error for what is no such
/// image.
std::unique_ptr<PageFile> open_pages(const std::filesystem::path& file);

// What reads the kinds of them; each as open_pages().
std::unique_ptr<PageFile> open_tiff(const std::filesystem::path& file);
std::unique_ptr<PageFile> open_png(const std::filesystem::path& file);
std::unique_ptr<PageFile> open_pnm(const std::filesystem::path& file);
std::unique_ptr<PageFile> open_jpeg(const std::filesystem::path& file);
std::unique_ptr<PageFile> open_other_image(const std::filesystem::path& file);

/// The message of an Error about one page, counted from 0.
inline std::string page_fault(const std::filesystem::path& file, std::size_t page, const std::string& what) {
  return fmt::format("{}: page {} could not be read: {}", file.string(), page + 1, what);
}

}  // namespace crest
