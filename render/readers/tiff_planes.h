#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "render/readers/tiff_file.h"

// What order_planes() is made of: a description's kind each. `name` begins their Errors.
namespace crest {

/// Where a plane's page stands in PlaneOrder::pages.
std::size_t place_in(const PlaneOrder& order, std::size_t component, std::size_t slice, std::size_t frame);
/// Where one axis alone is longer than 1, it is the volume's third one.
void take_only_axis_as_slices(PlaneOrder& order);
/// Each page is a slice, but for smaller copies of others, and masks.
PlaneOrder order_pages(const TiffDescription& description, std::size_t pages);
inline constexpr const char* unknown_distance = "the slices' distance is not known, and taken as 1";

/// ImageJ's "hyperstacks": keys and values, a line each.
bool is_imagej(const std::string& text);
PlaneOrder order_imagej(const std::string& name, const TiffDescription& description, std::size_t pages);
/// Of one page: its lengths and values. Whether the description tells of channels or frames.
bool take_one_of_imagej(const TiffDescription& description, PlaneOrder& order);

/// OME-TIFF's XML.
bool is_ome(const std::string& text);
PlaneOrder order_ome(const std::string& name, const TiffDescription& description, std::size_t pages);
bool take_one_of_ome(const std::string& text, PlaneOrder& order);

/// What Python's tifffile writes of an array, as JSON.
bool is_shaped(const std::string& text);
PlaneOrder order_shaped(const TiffDescription& description, std::size_t pages);

}  // namespace crest
