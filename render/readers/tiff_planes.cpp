// ImageJ's "hyperstacks", and OME-TIFF (docs.openmicroscopy.org, ome-model, specification).
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <pugixml.hpp>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/tiff_file.h"
#include "render/readers/voxel_header.h"
#include "render/volume/memory.h"
#include "render/volume/query.h"

namespace crest {
namespace {

std::size_t place_in(const PlaneOrder& order, std::size_t component, std::size_t slice, std::size_t frame) {
  return (frame * order.components + component) * order.slices + slice;
}

/// Where one axis alone is longer than 1, it is the volume's third one.
void take_only_axis_as_slices(PlaneOrder& order, std::string_view components, std::string_view frames) {
  if (order.slices > 1 || (order.components > 1) == (order.frames > 1)) return;
  add_note(order.note, fmt::format("its {} are taken as slices", order.components > 1 ? components : frames));
  order.slices = order.components * order.frames;
  order.components = order.frames = 1;
}

using ImageJFields = std::map<std::string, std::string, std::less<>>;

/// ImageJ's values are a function of the stored ones, "cf": signed ones are kept so, as c0=-32768 and c1=1.
void take_calibration(const ImageJFields& fields, PlaneOrder& order) {
  constexpr std::int64_t straight_line = 0, none = 20;
  const auto number = [&](const char* key) {
    const auto found = fields.find(key);
    return found == fields.end() ? std::nullopt : to_number(found->second);
  };
  const auto function = number("cf"), intercept = number("c0"), slope = number("c1");
  if (!function || *function == none) return;
  if (*function == straight_line && intercept && slope)
    order.scaling = {*slope, *intercept};
  else
    add_note(order.note, "ImageJ's calibration of its values is not applied: it is no straight line");
}

ImageJFields imagej_fields(const std::string& description) {
  ImageJFields fields;
  HeaderLines lines(description);
  std::string_view line;
  while (lines.next(line)) {
    const std::size_t equals = line.find('=');
    if (equals != std::string_view::npos)
      fields.emplace(trim(line.substr(0, equals)), trim(line.substr(equals + 1)));
  }
  return fields;
}

/// 1 where it says no such number.
std::size_t count_of(const ImageJFields& fields, const char* key) {
  const auto found = fields.find(key);
  const auto value = found == fields.end() ? std::nullopt : to_integer(found->second);
  return value && *value > 0 && *value < (1 << 24) ? std::size_t(*value) : 1;
}

void take_imagej_spacing(const ImageJFields& fields, const TiffDescription& description, PlaneOrder& order) {
  const auto spacing = fields.find("spacing");
  const auto z = spacing == fields.end() ? std::nullopt : to_number(spacing->second);
  const double x = description.pixels_per_unit_x, y = description.pixels_per_unit_y;
  const bool has_unit = fields.contains("unit") && fields.at("unit") != "pixel";
  if (!z && !has_unit) return;
  order.spacing = {x > 0 && has_unit ? 1 / x : 1, y > 0 && has_unit ? 1 / y : 1, z ? std::abs(*z) : 1};
  if (has_unit) order.lengths = fmt::format("lengths in {}", one_line(fields.at("unit")));
}

PlaneOrder order_imagej(const std::string& name, const TiffDescription& description, std::size_t pages) {
  const ImageJFields fields = imagej_fields(description.text);
  PlaneOrder order;
  order.components = count_of(fields, "channels"), order.slices = count_of(fields, "slices");
  order.frames = count_of(fields, "frames");
  const auto slices = checked_product(order.components, order.slices);
  const auto planes = slices ? checked_product(*slices, order.frames) : std::nullopt;
  if (planes == 1)
    order.slices = pages;
  else if (planes != pages)
    throw Error(fmt::format(
        "{}: its ImageJ description tells of {} images ({} channels, {} slices, {} frames), and the "
        "file has {}",
        name, planes ? fmt::format("{}", *planes) : "over 2^64", order.components, order.slices, order.frames,
        pages));
  order.pages.resize(pages);
  for (std::size_t page = 0; page < pages; ++page) {  // channels first, then slices
    const std::size_t component = page % order.components, slice = page / order.components % order.slices;
    order.pages[place_in(order, component, slice, page / order.components / order.slices)] = page;
  }
  take_imagej_spacing(fields, description, order);
  take_calibration(fields, order);
  take_only_axis_as_slices(order, "channels", "frames");
  return order;
}

/// Sizes of OME's planes, by their letters.
struct OmeSizes {
  std::string letters;  ///< of C, Z and T, the fastest first
  std::map<char, std::size_t> size = {{'C', 1}, {'Z', 1}, {'T', 1}};
};

std::array<std::size_t, 3> plane_at(const OmeSizes& sizes, std::size_t number) {
  std::map<char, std::size_t> at;
  for (const char letter : sizes.letters) {
    at[letter] = number % sizes.size.at(letter);
    number /= sizes.size.at(letter);
  }
  return {at['C'], at['Z'], at['T']};
}

std::size_t number_of(const OmeSizes& sizes, std::size_t c, std::size_t z, std::size_t t) {
  std::size_t number = 0, step = 1;
  for (const char letter : sizes.letters) {
    number += step * (letter == 'C' ? c : letter == 'Z' ? z : t);
    step *= sizes.size.at(letter);
  }
  return number;
}

/// Where each plane's page is; the planes of other files are none of this one's.
void take_tiff_data(const std::string& name, pugi::xml_node pixels, const OmeSizes& sizes, std::size_t pages,
                    PlaneOrder& order) {
  const std::size_t planes = order.pages.size();
  std::vector<bool> found(planes, false);
  const auto put = [&](std::size_t plane, std::size_t page) {
    if (plane >= planes || page >= pages)
      throw Error(fmt::format("{}: its OME description tells of {} planes, and the file has {} pages", name,
                              planes, pages));
    const auto [c, z, t] = plane_at(sizes, plane);
    order.pages[place_in(order, c, z, t)] = page;
    found[plane] = true;
  };
  const auto blocks = pixels.children("TiffData");
  for (const pugi::xml_node block : blocks) {
    const pugi::xml_attribute ifd = block.attribute("IFD");
    const std::size_t first =
        number_of(sizes, block.attribute("FirstC").as_uint(), block.attribute("FirstZ").as_uint(),
                  block.attribute("FirstT").as_uint());
    const std::size_t count =
        block.attribute("PlaneCount").as_uint(ifd ? 1u : unsigned(std::min<std::size_t>(planes, 1u << 24)));
    for (std::size_t i = 0; i < std::min(count, planes); ++i) put(first + i, ifd.as_uint() + i);
  }
  if (blocks.begin() == blocks.end())
    for (std::size_t plane = 0; plane < planes; ++plane) put(plane, plane);
  if (std::ranges::find(found, false) != found.end())
    throw Error(
        fmt::format("{}: its OME description tells of {} planes, some of which are in no page of this file",
                    name, planes));
}

/// How many micrometres a unit of OME's is; nothing for "pixel" and "reference frame", which are no lengths,
/// and for others that no microscope has.
std::optional<double> micrometres_of(const std::string& unit) {
  static const std::map<std::string_view, double> units = {
      {"µm", 1},   {"\u03bcm", 1}, {"um", 1},   {"nm", 1e-3}, {"pm", 1e-6},
      {"Å", 1e-4}, {"mm", 1e3},    {"cm", 1e4}, {"m", 1e6},   {"in", 25400}};
  const auto found = units.find(unit);
  return found == units.end() ? std::nullopt : std::optional(found->second);
}

constexpr const char* unknown_distance = "the slices' distance is not known, and taken as 1";

void take_ome_spacing(pugi::xml_node pixels, PlaneOrder& order) {
  glm::dvec3 spacing;
  std::string others;
  for (const auto& [axis, key] :
       {std::pair(0, "PhysicalSizeX"), {1, "PhysicalSizeY"}, {2, "PhysicalSizeZ"}}) {
    const std::string unit = pixels.attribute(fmt::format("{}Unit", key).c_str()).as_string("µm");
    const auto micrometres = micrometres_of(unit);
    spacing[axis] = pixels.attribute(key).as_double(0) * micrometres.value_or(1);
    if (!micrometres && others.find(unit) == std::string::npos)
      others += fmt::format("{}\"{}\"", others.empty() ? "" : " and ", one_line(unit.substr(0, 40)));
  }
  if (!(spacing.x > 0 && spacing.y > 0)) return;
  order.spacing = {spacing.x, spacing.y, spacing.z > 0 ? spacing.z : 1};
  order.lengths = others.empty() ? "lengths in micrometres" : fmt::format("lengths in {}", others);
  if (!(spacing.z > 0)) add_note(order.lengths, unknown_distance);
}

/// Channels of a pixel in one plane.
unsigned samples_of(pugi::xml_node pixels) {
  return std::max(1u, pixels.child("Channel").attribute("SamplesPerPixel").as_uint(1));
}

PlaneOrder order_ome(const std::string& name, const std::string& text, std::size_t pages) {
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());
  const pugi::xml_node pixels = document.first_element_by_path("OME/Image/Pixels");
  if (!pixels) throw Error(fmt::format("{}: its OME description has no pixels", name));
  OmeSizes sizes;
  for (const char letter : std::string_view(pixels.attribute("DimensionOrder").as_string("XYZCT")))
    if (letter == 'C' || letter == 'Z' || letter == 'T') sizes.letters += letter;
  if (sizes.letters.size() != 3)
    throw Error(fmt::format("{}: its OME description has no order of dimensions", name));
  constexpr std::size_t longest = std::size_t(1) << 20;
  for (auto& [letter, size] : sizes.size)
    size = std::clamp<std::size_t>(pixels.attribute(fmt::format("Size{}", letter).c_str()).as_uint(1), 1,
                                   longest);
  const std::size_t samples = samples_of(pixels);
  if (sizes.size['C'] % samples == 0) sizes.size['C'] /= samples;
  PlaneOrder order;
  order.components = sizes.size['C'], order.slices = sizes.size['Z'], order.frames = sizes.size['T'];
  const std::size_t planes = order.components * order.slices * order.frames;
  if (planes > pages)
    throw Error(fmt::format("{}: its OME description tells of {} planes, and the file has {} pages", name,
                            planes, pages));
  order.pages.resize(planes);
  take_tiff_data(name, pixels, sizes, pages, order);
  take_ome_spacing(pixels, order);
  if (const auto images = document.child("OME").children("Image"); std::next(images.begin()) != images.end())
    add_note(order.note,
             fmt::format("the first of its {} images", std::distance(images.begin(), images.end())));
  take_only_axis_as_slices(order, "channels", "frames");
  return order;
}

/// Each page is a slice, but for smaller copies of others, and masks.
PlaneOrder order_pages(const TiffDescription& description, std::size_t pages) {
  PlaneOrder order;
  order.pages = description.whole_pages;
  if (order.pages.empty()) {
    order.pages.resize(pages);
    std::iota(order.pages.begin(), order.pages.end(), std::size_t(0));
  }
  order.slices = order.pages.size();
  order.left_out = pages - order.slices;
  return order;
}

/// What Python's tifffile writes of an array.
constexpr std::string_view shaped_mark = "{\"shape\": [";

/// Of [..., z, y, x] all axes before z are frames; where one is said to be channels, it is components.
PlaneOrder order_shaped(const std::string& text, std::size_t pages) {
  const std::string_view list = std::string_view(text).substr(shaped_mark.size());
  std::vector<std::size_t> longer;  // than 1, of the axes whose product is the pages
  std::size_t all = 1;
  for (const std::string_view part : split(list.substr(0, list.find(']')), ',')) {
    const auto size = to_integer(trim(part)).value_or(0);
    if (all == pages || size < 1 || std::size_t(size) > pages / all) break;
    all *= std::size_t(size);
    if (size > 1) longer.push_back(std::size_t(size));
  }
  PlaneOrder order = order_pages({}, pages);
  if (all != pages || longer.size() < 2) return order;
  order.slices = longer.back();
  const bool channels = text.find("\"axes\": \"C") != std::string::npos && longer.size() == 2;
  (channels ? order.components : order.frames) = pages / order.slices;
  add_note(order.note, fmt::format("its axes are taken as {}, z, y, x", channels ? "channels" : "frames"));
  return order;
}

bool is_imagej(const std::string& text) { return text.starts_with("ImageJ="); }
bool is_ome(const std::string& text) { return text.find("<OME") != std::string::npos; }

/// A file of one page is often one of many, whose order its description tells: lengths and values are its
/// own.
PlaneOrder order_one(const TiffDescription& description) {
  PlaneOrder order;
  order.pages = {0};
  bool tells_more = false;
  if (is_imagej(description.text)) {
    const ImageJFields fields = imagej_fields(description.text);
    tells_more = count_of(fields, "channels") > 1 || count_of(fields, "frames") > 1;
    take_imagej_spacing(fields, description, order);
    if (order.spacing && !fields.contains("spacing")) add_note(order.lengths, unknown_distance);
    take_calibration(fields, order);
  } else if (is_ome(description.text)) {
    pugi::xml_document document;
    document.load_buffer(description.text.data(), description.text.size());
    const pugi::xml_node pixels = document.first_element_by_path("OME/Image/Pixels");
    tells_more =
        pixels.attribute("SizeC").as_uint(1) > samples_of(pixels) || pixels.attribute("SizeT").as_uint(1) > 1;
    take_ome_spacing(pixels, order);
  }
  if (tells_more) add_note(order.note, "channels and frames that descriptions tell of are not taken apart");
  return order;
}

}  // namespace

std::size_t imagej_images(const std::string& description) {
  return is_imagej(description) ? count_of(imagej_fields(description), "images") : 1;
}

PlaneOrder order_planes(const std::string& name, const TiffDescription& description, std::size_t pages) {
  if (pages == 1) return order_one(description);
  if (is_imagej(description.text)) return order_imagej(name, description, pages);
  if (is_ome(description.text)) return order_ome(name, description.text, pages);
  if (description.text.starts_with(shaped_mark)) return order_shaped(description.text, pages);
  return order_pages(description, pages);
}

}  // namespace crest
