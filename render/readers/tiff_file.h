#pragma once

#include <bit>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/readers/page_file.h"
#include "render/volume/voxels.h"

namespace crest {

/// What a TIFF file tells of its pages, in the first one.
struct TiffDescription {
  std::string text;  ///< ImageDescription
  double pixels_per_unit_x = 0, pixels_per_unit_y = 0;
  bool in_centimetres = false;           ///< that unit, as the file says; ImageJ's text may say another
  std::vector<std::size_t> whole_pages;  ///< neither smaller copies of others nor masks
};
TiffDescription describe_tiff(const std::filesystem::path& file);

/// Images that lie behind each other, of which the file's one page describes the first.
struct TiffStack {
  std::size_t images = 1;   ///< as ImageJ's description tells
  std::uint64_t begin = 0;  ///< bytes before them
  std::endian endian = std::endian::little;
};
/// These as pages. `first`, where the file has no more than one. Throws Error where it lacks some.
std::unique_ptr<PageFile> open_imagej_stack(const std::filesystem::path& file,
                                            std::unique_ptr<PageFile> first, const TiffStack& stack);
/// `images=` of such a description, or 1.
std::size_t imagej_images(const std::string& description);

/// How the pages of a file follow each other: which page holds a slice of a component in a frame.
struct PlaneOrder {
  std::size_t components = 1, slices = 1, frames = 1;
  std::vector<std::size_t> pages;  ///< [(frame * components + component) * slices + slice]
  std::size_t left_out = 0;        ///< pages that are smaller copies of others, or masks
  std::optional<glm::dvec3> spacing;
  std::string lengths;  ///< a note on the spacing: its unit, and what is not known of it
  LinearMap scaling;    ///< from the stored values, where those are integers of 8 and 16 bits
  std::string note;
};
/// By the description of ImageJ, OME or tifffile; without one all whole pages are slices. Throws Error, which
/// begins with `name`, for a description that the `pages` contradict, but for a single one: it may be one
/// of many that the description tells of.
PlaneOrder order_planes(const std::string& name, const TiffDescription& description, std::size_t pages);

}  // namespace crest
