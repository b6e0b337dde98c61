// OME-TIFF (docs.openmicroscopy.org, ome-model, specification).
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <pugixml.hpp>

#include "presets/error.h"
#include "render/files/header_text.h"
#include "render/readers/tiff_planes.h"
#include "render/readers/voxel_header.h"

namespace crest {
namespace {

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

/// ", others of which are in t1.ome.tif", where the description names another file.
std::string other_file_text(const std::string& name, pugi::xml_node pixels) {
  for (const pugi::xml_node block : pixels.children("TiffData")) {
    const std::string file = block.child("UUID").attribute("FileName").as_string();
    if (!file.empty() && !name.ends_with(file))
      return fmt::format(": others are in {}, and one file that holds all is read", one_line(file));
  }
  return "";
}

/// Where each plane's page is; the planes of other files are none of this one's.
void take_tiff_data(const std::string& name, pugi::xml_node pixels, const OmeSizes& sizes, std::size_t pages,
                    PlaneOrder& order) {
  const std::size_t planes = order.pages.size();
  std::vector<bool> found(planes, false);
  const auto put = [&](std::size_t plane, std::size_t page) {
    if (plane >= planes || page >= pages)
      throw Error(fmt::format("{}: its OME description tells of {} planes, and the file has {} pages{}", name,
                              planes, pages, other_file_text(name, pixels)));
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
        fmt::format("{}: its OME description tells of {} planes, some of which are in no page of this file{}",
                    name, planes, other_file_text(name, pixels)));
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

}  // namespace

bool is_ome(const std::string& text) { return text.find("<OME") != std::string::npos; }

PlaneOrder order_ome(const std::string& name, const TiffDescription& description, std::size_t pages) {
  const std::string& text = description.text;
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());
  if (const auto elsewhere = document.child("OME").child("BinaryOnly")) {
    PlaneOrder order = order_pages(description, pages);
    add_note(order.note,
             fmt::format("its description is in {}, which is not read",
                         one_line(elsewhere.attribute("MetadataFile").as_string("another file"))));
    return order;
  }
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
    throw Error(fmt::format("{}: its OME description tells of {} planes, and the file has {} pages{}", name,
                            planes, pages, other_file_text(name, pixels)));
  order.pages.resize(planes);
  take_tiff_data(name, pixels, sizes, pages, order);
  take_ome_spacing(pixels, order);
  if (const auto images = document.child("OME").children("Image"); std::next(images.begin()) != images.end())
    add_note(order.note,
             fmt::format("the first of its {} images", std::distance(images.begin(), images.end())));
  take_only_axis_as_slices(order);
  return order;
}

bool take_one_of_ome(const std::string& text, PlaneOrder& order) {
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());
  const pugi::xml_node pixels = document.first_element_by_path("OME/Image/Pixels");
  take_ome_spacing(pixels, order);
  return pixels.attribute("SizeC").as_uint(1) > samples_of(pixels) ||
         pixels.attribute("SizeT").as_uint(1) > 1;
}

}  // namespace crest
